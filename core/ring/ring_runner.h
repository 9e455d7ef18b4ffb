// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/cyclic_driver.h"
#include "ring/command.h"
#include "ring/process_data_link.h"
#include "ring/ring_event.h"
#include "ring/snapshot.h"

#include <memory>

namespace codewheel {

// Owns OUT. Each cycle: carries out what was posted, exchanges all words, lets each driver answer, and
// publishes the snapshot. One writer per OUT word: while a driver has a job, a SetOut is refused with a
// message. ALARM STOP zeroes all OUT words and ends all jobs as stopped. Has no thread of its own: cycle() is
// called by PacedThread, by the command line in a loop, or by a test with any time. post(), takeEvents(),
// takeLatest(): any thread; all else by the caller of cycle().
//
// A word a driver answers in one cycle goes out in the next. The bus starts stopped and in Watch. While it is
// stopped or has failed nothing is exchanged and jobs end; words that were not exchanged are not sent later
// by themselves.
//
// Where the link reaches a master, its services start and stop the ring, and what it says of a fault decides
// the state. When the bus has failed, or after ALARM STOP, all OUT words are 0. A device that is not in the
// ring has no reading, and its driver waits. When the master has another ring active than the one the runner
// was made for, nothing is exchanged: ReadInEnded tells it, and somebody makes another runner.
class RingRunner
{
public:
    // A device without a driver (K1, unknown) has a null pointer.
    using Drivers = std::vector<std::unique_ptr<CyclicDriver>>;
    RingRunner(ProcessDataLink &link, RingStructure structure, Drivers drivers,
               std::vector<Word> outAsReadBack);
    ~RingRunner();

    void cycle(Instant now);
    // Before the first cycle: writing was allowed already.
    void beginOperating();
    // The computer slept so long, just before `now`: the jobs end, what was not exchanged is not sent any
    // more, and the bus is in Watch.
    void slept(std::chrono::milliseconds duration, Instant now);
    // Before another runner takes over, any number of times: carries out what was posted, and ends the jobs.
    void finish(Instant now);
    Drivers takeDrivers(); // by place; no call but takeEvents() afterwards
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
