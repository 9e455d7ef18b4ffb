// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/sleep_watch.h"

#include <chrono>
#include <thread>

namespace codewheel {

class BusWork;

// How the thread of a bus is paced.
struct Pacing
{
    // Of the turns, on absolute deadlines of the steady clock; 0: whenever the link's own waiting allows.
    std::chrono::nanoseconds period{};
    SleepWatch::Slept slept = SleepWatch::ofThisComputer;
};

// The thread of a bus: opens the link unless it is open, takes turns, and at its end closes the link, which
// interrupts a blocking call. If opening was refused it does nothing more. The work must outlive it.
class BusThread
{
public:
    // The first turn comes at once. If the computer slept, the work is told before the next turn.
    BusThread(BusWork &work, Pacing pacing, bool isLinkOpen);
    ~BusThread();

    BusThread(const BusThread &) = delete;
    BusThread &operator=(const BusThread &) = delete;

private:
    BusWork &m_work;
    std::jthread m_thread;
};

} // namespace codewheel
