// SPDX-License-Identifier: GPL-3.0-or-later
// Reading an EDS of 1300 objects.
#include "kinds/canopen/eds/device_file_reader.h"
#include "tests/bench/large_eds.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using namespace codewheel;

constexpr int rounds = 25;

} // namespace

int main()
{
    const QByteArray bytes = bench::largeEds();
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        QElapsedTimer timer;
        timer.start();
        const auto file = canopen::readDeviceFile(bytes);
        times.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
        if (!file || file->objects.size() != std::size_t{bench::largeEdsObjects})
            return 1;
    }
    std::ranges::sort(times);
    std::printf("%d objects, %lld kB: read in %.1f ms, at most %.1f ms\n", bench::largeEdsObjects,
                static_cast<long long>(bytes.size() / 1024), times[rounds / 2], times.back());
    return 0;
}
