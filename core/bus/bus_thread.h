// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/sleep_watch.h"

#include <chrono>
#include <thread>

namespace codewheel {

class BusWork;

// How the thread of a bus goes about it.
struct Pacing
{
    // Of the turns, on absolute deadlines of the steady clock; 0: as the link's own waiting lets them come.
    std::chrono::nanoseconds period{};
    SleepWatch::Slept slept = SleepWatch::ofThisComputer;
};

// The thread of a bus: opens the link unless it is open, takes turns, and closes the link at its end, which
// interrupts a call that blocks. After a refusal to open it does nothing more. The work must outlive it.
class BusThread
{
public:
    // The first turn comes at once. After the computer slept the work is told before the next one.
    BusThread(BusWork &work, Pacing pacing, bool isLinkOpen);
    ~BusThread();

    BusThread(const BusThread &) = delete;
    BusThread &operator=(const BusThread &) = delete;

private:
    BusWork &m_work;
    std::jthread m_thread;
};

} // namespace codewheel
