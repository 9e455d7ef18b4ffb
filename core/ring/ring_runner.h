// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/cyclic_driver.h"
#include "encoder/message.h"
#include "ring/process_data_link.h"
#include "ring/snapshot.h"

#include <functional>
#include <memory>
#include <mutex>

namespace codewheel {

class ExchangeTrace;
class LatestSnapshot;

// What the window asks of the bus thread.
namespace command {
struct SetOut
{
    std::size_t device;
    Word word;
};
struct StartJob
{
    std::size_t device;
    JobId id;
    Job job;
    Pace pace;
};
struct Proceed
{
    std::size_t device;
};
struct Cancel
{
    std::size_t device;
    OnCancel how;
};
struct SetKnown
{
    std::size_t device;
    std::vector<Known> known;
};
struct StartBus
{};
struct StopBus
{};
struct SetOperate
{
    bool on;
};
struct AlarmStop
{};
} // namespace command
using Command =
    std::variant<command::SetOut, command::StartJob, command::Proceed, command::Cancel, command::SetKnown,
                 command::StartBus, command::StopBus, command::SetOperate, command::AlarmStop>;

// What the bus thread tells the window; a device is given by its place in the ring.
struct RingEvent
{
    std::size_t device = 0; // meaningless for messages without a place
    std::variant<Event, Exchange, Message> what;
};

// Owns OUT. Each cycle: carries out what was posted, exchanges all words, lets each driver answer, and
// publishes the snapshot. One writer per OUT word: while a driver has a job, a SetOut is refused with a
// message. ALARM STOP zeroes all OUT words and ends all jobs as stopped. Has no thread of its own: cycle() is
// called by PacedThread, by the command line in a loop, or by a test with any time. post(), takeEvents(),
// latest(): any thread; all else by the caller of cycle().
class RingRunner
{
public:
    // A device without a driver (K1, unknown) has a null pointer.
    using Drivers = std::vector<std::unique_ptr<CyclicDriver>>;
    RingRunner(ProcessDataLink &link, RingStructure structure, Drivers drivers,
               std::vector<Word> outAsReadBack);
    ~RingRunner();

    void cycle(Instant now);
    void post(Command command);
    std::vector<RingEvent> takeEvents();
    // The newest snapshot with all edges since the last call; nothing if none came since.
    std::shared_ptr<const Snapshot> takeLatest();
    // Counted by the paced thread.
    void setPacing(std::chrono::nanoseconds period, std::uint64_t lateCycles);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
