// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace codewheel::bench {

// Used by all threads of this process so far: what else runs on the machine does not count.
inline double processorSeconds()
{
    timespec used{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

double processorSecondsOf(auto work)
{
    const double before = processorSeconds();
    work();
    return processorSeconds() - before;
}

// Of several frames, in milliseconds.
struct FrameTimes
{
    double median = 0;
    double longest = 0;
};

// After some frames that do not count.
FrameTimes timesOf(int frames, auto show)
{
    constexpr int warmUp = 20;
    std::vector<double> times;
    for (int frame = 0; frame < warmUp + frames; ++frame) {
        const double seconds = processorSecondsOf([&] { show(frame); });
        if (frame >= warmUp)
            times.push_back(1'000 * seconds);
    }
    std::ranges::sort(times);
    return {times[times.size() / 2], times.back()};
}

} // namespace codewheel::bench
