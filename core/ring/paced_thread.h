// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/sleep_watch.h"

#include <chrono>
#include <thread>

namespace codewheel {

class ProcessDataLink;
class RingRunner;

// The bus thread: calls cycle() of a runner on absolute deadlines of the steady clock, from its making to its
// end. The end interrupts a call that blocks in the link. Runner and link must outlive it.
class PacedThread
{
public:
    // period > 0. The first cycle comes at once and is at `from`. After the computer slept the runner is told
    // before the next cycle.
    PacedThread(RingRunner &runner, ProcessDataLink &link, std::chrono::nanoseconds period, Instant from,
                SleepWatch::Slept slept = SleepWatch::ofThisComputer);
    ~PacedThread();

    PacedThread(const PacedThread &) = delete;
    PacedThread &operator=(const PacedThread &) = delete;

private:
    ProcessDataLink &m_link;
    std::jthread m_thread;
};

} // namespace codewheel
