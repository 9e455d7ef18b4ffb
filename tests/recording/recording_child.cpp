// SPDX-License-Identifier: GPL-3.0-or-later
// The child of test_recording_killed.cpp: records until it is killed, and prints up to which value everything
// was promised to be in the file.
//
//   recording_child FILE
#include "recording/recording_writer.h"

#include <QCoreApplication>

#include <cstdio>

int main(int argc, char **argv)
{
    using namespace codewheel;
    const QCoreApplication application(argc, argv);
    const auto writer =
        RecordingWriter::begin({.file = QCoreApplication::arguments().value(1), .leastFree = 0});
    if (!writer)
        return 1;
    const Place place{firstRing, NodeId("1.0")};
    std::int64_t value = 1;
    for (int round = 0;; ++round) {
        ShownSeries series;
        for (int i = 0; i < 300; ++i, ++value)
            series.push_back(
                {.at = std::chrono::milliseconds(value),
                 .position = value,
                 .words = ExchangedWords{static_cast<Word>(7 * value), static_cast<Word>(round)}});
        (*writer)->add(RecordedValues{place, std::move(series)});
        (*writer)->add(
            RecordedMessage{std::chrono::milliseconds(value), {.place = place, .id = MessageId::busStarted}});
        (*writer)->flush();
        if ((*writer)->status().problem)
            return 2;
        std::printf("%lld\n", static_cast<long long>(value - 1));
        std::fflush(stdout);
    }
}
