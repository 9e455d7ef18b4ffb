// SPDX-License-Identifier: GPL-3.0-or-later
// The child of test_recording_killed.cpp and test_server_killed.cpp: records until it is killed, and prints
// up to which value everything was promised to be in the file, or, as long as the server is away, to follow.
//
//   recording_child FILE
//   recording_child FOLDER ADDRESS
#include "recording/recording_target.h"

#include <QCoreApplication>

#include <cstdio>

int main(int argc, char **argv)
{
    using namespace codewheel;
    const QCoreApplication application(argc, argv);
    const QString path = QCoreApplication::arguments().value(1);
    const QString server = QCoreApplication::arguments().value(2);
    const auto writer =
        RecordingTarget::begin({.file = path, .server = server, .leastFree = 0, .unsentFolder = path});
    if (!writer)
        return 1;
    const Place place{firstBus, NodeId("1.0")};
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
        const auto problem = (*writer)->status().problem;
        if (problem && problem->id != RefusalId::serverAway)
            return 2;
        std::printf("%lld\n", static_cast<long long>(value - 1));
        std::fflush(stdout);
    }
}
