// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_work.h"
#include "kinds/interbus/ring/command.h"
#include "kinds/interbus/ring/process_data_link.h"
#include "kinds/interbus/ring/ring_event.h"
#include "kinds/interbus/ring/snapshot.h"

#include <memory>

namespace codewheel {

// Owns OUT. Each cycle: carries out what was posted, exchanges all words, lets each driver answer, and
// publishes the snapshot. One writer per OUT word: while a driver has a job, a SetOut is refused with a
// message. ALARM STOP zeroes all OUT words and ends all jobs as stopped.
//
// A word a driver answers in one cycle goes out in the next. The bus starts stopped and in Watch. While it is
// stopped or has failed nothing is exchanged and jobs end; words that were not exchanged are not sent later
// automatically.
//
// open() finds out which ring there is and reports it; UseRing brings the drivers for it. The same happens
// when the master has a different ring active than before: nothing is exchanged until then.
//
// If the link reaches a master, its services start and stop the ring, and what it says about a fault decides
// the state. When the bus has failed, or after ALARM STOP, all OUT words are 0. A device that is not in the
// ring has no reading, and its driver waits.
//
// A link that refuses an exchange is lost: that is reported, and the link is tried again every second. When
// it is back the bus is in Watch, with OUT as it is on the peer, and runs if it ran before and a master has
// not stopped it meanwhile. What was asked of a lost bus concerning its running is done then: start, stop,
// ALARM STOP.
class RingRunner final : public BusRunner<Command, RingEvent, Snapshot>
{
public:
    explicit RingRunner(ProcessDataLink &link);
    ~RingRunner() override;

    Result<void> open(const std::stop_token &stop) override;
    void turn(Instant until) override;
    void cycle(Instant now);
    void slept(std::chrono::milliseconds duration) override;
    void close() override;
    Instant now() const override;
    void setPacing(std::chrono::nanoseconds period, std::uint64_t lateCycles) override;
    bool keepsPace() const override;
    void interrupt() override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
