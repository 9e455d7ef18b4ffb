// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "history/history.h"
#include "history/shown_channels.h"
#include "vocabulary/message.h"

#include <variant>

namespace codewheel {

// What comes into a recording. Times are those of the recording: since 1970, UTC, by the clock of the bus
// (EncoderBus::sinceEpoch), which never goes back.

struct RecordedBus
{
    BusId bus;
    QString name;
};
// What is in force from `since` on for the device there: JSON (recording/recorded_device.h).
struct RecordedDescription
{
    Place place;
    Instant since{};
    QByteArray json;
};
struct RecordedValues
{
    Place place;
    ShownSeries values;
};
// What was shown before the recording began, oldest first; nothing was known in the gaps.
struct RecordedPast
{
    Place place;
    Channel channel = Channel::position;
    std::vector<Sample> samples;
    std::vector<History::Gap> gaps{};
    Instant until{}; // the last value stood until then
};
// From then on nothing is known of the device, of all of a bus (a place without a node), or of all, until
// they show something again.
struct RecordedInterruption
{
    std::optional<Place> place{};
    Instant at{};
};
struct RecordedMessage
{
    Instant at{};
    Message message;
};
struct RecordedTraffic
{
    Instant at{};
    BusId bus;
    TrafficRow row;
};
// An empty text removes the note of that moment.
struct RecordedNote
{
    Instant at{};
    QString text;
};
// Values that came too fast: of a bus, or, without one, for the recording.
struct RecordedLoss
{
    Instant at{};
    BusId bus;
    std::uint64_t count = 0;
};
// What the clock of the computer said, since 1970, UTC.
struct RecordedClock
{
    Instant at{};
    Instant wall{};

    friend bool operator==(const RecordedClock &, const RecordedClock &) = default;
};

using RecordingEntry =
    std::variant<RecordedBus, RecordedDescription, RecordedValues, RecordedPast, RecordedInterruption,
                 RecordedMessage, RecordedTraffic, RecordedNote, RecordedLoss, RecordedClock>;

// How much memory it takes, roughly, and how many values it has that would be lost with it.
std::size_t bytesOf(const RecordingEntry &entry);
std::uint64_t valuesOf(const RecordingEntry &entry);

} // namespace codewheel
