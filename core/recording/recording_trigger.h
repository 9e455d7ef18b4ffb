// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recording_entry.h"

namespace codewheel {

class EncoderHistory;

// What makes a recording begin: a bit of a word or a cam that changes, a value that passes a threshold, a
// message.
struct BitTrigger
{
    Place place;
    Channel channel = Channel::in; // in, out or cams
    unsigned bit = 0;
    bool rising = true; // else falling
};
struct ThresholdTrigger
{
    Place place;
    Channel channel = Channel::position;
    std::int64_t threshold = 0; // in the units of the channel
    bool rising = true;         // from below it to it, or above; else from it, or above, to below
};
struct MessageTrigger
{
    std::optional<Place> place{}; // nothing: anywhere; a bus: anywhere on it
    Severity least = Severity::fault;
};
using RecordingTrigger = std::variant<BitTrigger, ThresholdTrigger, MessageTrigger>;

// Waits for a trigger. Values are those of the recording, in the order they came. A value counts from the
// first one known: what is already beyond a threshold has to come back before it can pass it, and so has one
// that was unknown meanwhile.
class TriggerWatch
{
public:
    explicit TriggerWatch(RecordingTrigger trigger)
        : m_trigger(trigger)
    {}

    // When it happened; nothing: not in these.
    std::optional<Instant> take(Place place, const ShownSeries &values);
    std::optional<Instant> take(const RecordedMessage &message) const;

private:
    std::optional<bool> stateOf(Place place, const ShownValues &shown) const;

    RecordingTrigger m_trigger;
    std::optional<bool> m_state; // of the bit, or whether the threshold is reached
};

// How much is recorded around the moment of a trigger, or from the beginning by hand.
struct RecordingExtent
{
    Instant before{};
    std::optional<Instant> after{}; // nothing: until it is ended by hand

    TimeSpan around(Instant at) const
    {
        return {std::max(at - before, Instant(0)), after ? at + *after : Instant::max()};
    }
};

// What a history has of a span, to begin a recording with.
std::vector<RecordedPast> pastOf(Place place, const EncoderHistory &history, const TimeSpan &span);

} // namespace codewheel
