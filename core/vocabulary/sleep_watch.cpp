// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/sleep_watch.h"

#include <ctime>

namespace codewheel {
namespace {

std::chrono::nanoseconds timeOf(clockid_t clock)
{
    std::timespec time{};
    clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

} // namespace

// Linux: CLOCK_MONOTONIC stands still during sleep, CLOCK_BOOTTIME does not (clock_gettime(2)).
std::chrono::milliseconds SleepWatch::ofThisComputer()
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(timeOf(CLOCK_BOOTTIME) -
                                                                 timeOf(CLOCK_MONOTONIC));
}

} // namespace codewheel
