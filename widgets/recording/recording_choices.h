// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/track.h"
#include "recording/recording_trigger.h"

#include <QJsonObject>

#include <set>

namespace codewheel {

// What is chosen to make a recording begin.
struct TriggerChoice
{
    enum class Kind : std::uint8_t { atOnce, bit, threshold, fault, attention, message };

    Kind kind = Kind::atOnce;
    Place place{}; // of a message: none is anywhere, without a node a whole bus
    Channel channel = Channel::in;
    unsigned bit = 0;
    bool rising = true;
    double value = 0; // of a threshold, in this unit
    TrackUnit unit = TrackUnit::steps;

    friend bool operator==(const TriggerChoice &, const TriggerChoice &) = default;
};

// What the dialog was left with, and begins with next time.
struct RecordingChoices
{
    QString folder{};         // empty: the usual one
    std::set<Place> places{}; // empty: all encoders
    bool withTraffic = true;
    TriggerChoice trigger{};
    Instant before = std::chrono::seconds(10);
    Instant after = std::chrono::minutes(1);
    bool endsByItself = false; // after that
    Instant keptFor = std::chrono::hours(24);
    bool isKeptFor = false;  // only that long
    int largestSize = 1'000; // MB
    bool hasLargestSize = false;
    int leastFree = 1'000; // MB

    friend bool operator==(const RecordingChoices &, const RecordingChoices &) = default;
};

QJsonObject toJson(const RecordingChoices &choices);
// What it does not understand is as at first.
RecordingChoices recordingChoices(const QJsonObject &json);

} // namespace codewheel
