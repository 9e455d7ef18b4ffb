// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_thread.h"

#include "bus/bus_work.h"
#include "bus/pacer.h"

#include <algorithm>

namespace codewheel {
namespace {

using Clock = std::chrono::steady_clock;

// A stop is noticed after this long, whatever the period, and on a quiet line.
constexpr std::chrono::milliseconds longestSleep{10};
constexpr std::chrono::milliseconds longestTurn{50};

// False: asked to stop meanwhile.
bool sleepUntil(Clock::time_point deadline, const std::stop_token &stop)
{
    while (!stop.stop_requested()) {
        const Clock::time_point now = Clock::now();
        if (now >= deadline)
            return true;
        std::this_thread::sleep_until(std::min(deadline, now + longestSleep));
    }
    return false;
}

void tellSleep(BusWork &work, SleepWatch &sleep)
{
    if (const auto slept = sleep.sleptSinceLast(); slept.count() > 0)
        work.slept(slept);
}

// A virtual clock goes by the same deadlines.
void takePacedTurns(const std::stop_token &stop, BusWork &work, std::chrono::nanoseconds period,
                    SleepWatch &sleep)
{
    const Clock::time_point start = Clock::now();
    const Instant begin = work.now();
    Pacer pacer(start, period);
    while (sleepUntil(pacer.deadline(), stop)) {
        tellSleep(work, sleep);
        work.setPacing(period, pacer.lateCycles());
        work.turn(begin + std::chrono::duration_cast<Instant>(pacer.deadline() - start));
        pacer.cycleEnded(Clock::now(), work.keepsPace());
    }
}

void takeTurns(const std::stop_token &stop, BusWork &work, SleepWatch &sleep)
{
    while (!stop.stop_requested()) {
        tellSleep(work, sleep);
        work.turn(work.now() + longestTurn);
    }
}

} // namespace

BusThread::BusThread(BusWork &work, Pacing pacing, bool isLinkOpen)
    : m_work(work)
    , m_thread([&work, period = pacing.period, isLinkOpen,
                sleep = SleepWatch(std::move(pacing.slept))](const std::stop_token &stop) mutable {
        if (!isLinkOpen && !work.open(stop))
            return;
        if (period.count() > 0)
            takePacedTurns(stop, work, period, sleep);
        else
            takeTurns(stop, work, sleep);
        work.close();
    })
{}

BusThread::~BusThread()
{
    m_thread.request_stop();
    m_work.interrupt();
}

} // namespace codewheel
