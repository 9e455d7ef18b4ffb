// SPDX-License-Identifier: GPL-3.0-or-later
// Starts a program and passes it the time: see app/window/start_probe.h.
#include <chrono>
#include <cstdlib>
#include <string>
#include <unistd.h>

int main(int argc, char **argv)
{
    if (argc < 2)
        return 2;
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    setenv("CODEWHEEL_MEASURE_START", std::to_string(nanoseconds).c_str(), 1);
    execv(argv[1], argv + 1);
    return 1;
}
