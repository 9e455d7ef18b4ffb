// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/paced_thread.h"

#include "ring/pacer.h"
#include "ring/process_data_link.h"
#include "ring/ring_runner.h"

#include <algorithm>

namespace codewheel {
namespace {

using Clock = std::chrono::steady_clock;

// A stop is noticed after this long, even with a long period.
constexpr std::chrono::milliseconds longestSleep{10};

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

void runCycles(const std::stop_token &stop, RingRunner &runner, std::chrono::nanoseconds period, Instant from,
               SleepWatch sleep)
{
    const Clock::time_point start = Clock::now();
    Pacer pacer(start, period);
    while (sleepUntil(pacer.deadline(), stop)) {
        const Instant now = from + std::chrono::duration_cast<Instant>(Clock::now() - start);
        if (const auto slept = sleep.sleptSinceLast(); slept.count() > 0)
            runner.slept(slept, now);
        runner.setPacing(period, pacer.lateCycles());
        runner.cycle(now);
        pacer.cycleEnded(Clock::now());
    }
}

} // namespace

PacedThread::PacedThread(RingRunner &runner, ProcessDataLink &link, std::chrono::nanoseconds period,
                         Instant from, SleepWatch::Slept slept)
    : m_link(link)
    , m_thread([&runner, period, from, sleep = SleepWatch(std::move(slept))](const std::stop_token &stop) {
        runCycles(stop, runner, period, from, sleep);
    })
{}

PacedThread::~PacedThread()
{
    m_thread.request_stop();
    m_link.interrupt();
}

} // namespace codewheel
