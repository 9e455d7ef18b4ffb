// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/start_probe.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace codewheel {

bool reportFirstPaint()
{
    const char *begin = std::getenv("CODEWHEEL_MEASURE_START");
    if (begin == nullptr)
        return false;
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    const auto taken = now - std::chrono::nanoseconds(std::strtoll(begin, nullptr, 10));
    std::printf("first paint: %.1f ms\n", std::chrono::duration<double, std::milli>(taken).count());
    std::fflush(stdout);
    return true;
}

void reportMemory()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:"))
            std::printf("memory: %.1f MB\n", std::strtod(line.c_str() + 6, nullptr) / 1024);
    std::fflush(stdout);
}

} // namespace codewheel
