// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recorded_device.h"
#include "recording/recording_reader.h"

#include <QJsonObject>

namespace codewheel {

// What is in a recording, for people and for programs.
struct RecordingFacts
{
    struct Encoder
    {
        Place place;
        RecordedDevice device;                                       // as known last
        std::vector<std::pair<Instant, RecordedDevice>> described{}; // since when, oldest first
        std::vector<Channel> channels{};
        TimeSpan span;
    };

    QString file;
    std::optional<qint64> bytes{}; // nothing: it is on a server
    RecordingHead head;
    WallClock clock;
    std::vector<RecordedBus> buses;
    std::vector<Encoder> encoders; // that have any samples
    RecordingReader::Counts counts;
    std::optional<TimeSpan> span; // of all; nothing: no samples

    static Result<RecordingFacts> of(const RecordingReader &reader);

    QString text() const;
    QJsonObject json() const;
};

// As typed for --from and --to, in the time zone of the computer: "2026-03-01T14:02:05.250".
QString recordedTimeText(const WallClock &clock, Instant at);

} // namespace codewheel
