// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_trigger.h"

#include "history/encoder_history.h"

namespace codewheel {
namespace {

std::optional<std::int64_t> valueOf(const ShownValues &shown, Channel channel)
{
    switch (channel) {
    case Channel::position:
        return shown.position;
    case Channel::speed:
        return shown.stepsPerSecond
                   ? std::optional<std::int64_t>(std::llround(*shown.stepsPerSecond * speedUnits))
                   : std::nullopt;
    case Channel::in:
        return shown.words ? std::optional<std::int64_t>(shown.words->in) : std::nullopt;
    case Channel::out:
        return shown.words ? std::optional<std::int64_t>(shown.words->out) : std::nullopt;
    case Channel::cams:
        break;
    }
    return shown.cams;
}

// Of the values of this place; nothing: it has none, or is not asked for.
struct TriggerState
{
    const Place &place;
    const ShownValues &shown;

    std::optional<bool> operator()(const BitTrigger &trigger) const
    {
        const auto value = trigger.place == place ? valueOf(shown, trigger.channel) : std::nullopt;
        return value ? std::optional(((static_cast<std::uint64_t>(*value) >> trigger.bit) & 1U) != 0)
                     : std::nullopt;
    }
    std::optional<bool> operator()(const ThresholdTrigger &trigger) const
    {
        const auto value = trigger.place == place ? valueOf(shown, trigger.channel) : std::nullopt;
        return value ? std::optional(*value >= trigger.threshold) : std::nullopt;
    }
    std::optional<bool> operator()(const MessageTrigger &) const { return {}; }
};

std::optional<Place> placeOf(const RecordingTrigger &trigger)
{
    if (const auto *bit = std::get_if<BitTrigger>(&trigger))
        return bit->place;
    if (const auto *threshold = std::get_if<ThresholdTrigger>(&trigger))
        return threshold->place;
    return {};
}

bool isRising(const RecordingTrigger &trigger)
{
    if (const auto *bit = std::get_if<BitTrigger>(&trigger))
        return bit->rising;
    const auto *threshold = std::get_if<ThresholdTrigger>(&trigger);
    return threshold != nullptr && threshold->rising;
}

} // namespace

std::optional<bool> TriggerWatch::stateOf(Place place, const ShownValues &shown) const
{
    return std::visit(TriggerState{place, shown}, m_trigger);
}

std::optional<Instant> TriggerWatch::take(Place place, const ShownSeries &values)
{
    if (placeOf(m_trigger) != place)
        return {};
    for (const ShownValues &shown : values) {
        const auto before = std::exchange(m_state, stateOf(place, shown));
        if (before && m_state && *before != *m_state && *m_state == isRising(m_trigger))
            return shown.at;
    }
    return {};
}

std::optional<Instant> TriggerWatch::take(const RecordedMessage &message) const
{
    const auto *trigger = std::get_if<MessageTrigger>(&m_trigger);
    if (trigger == nullptr || message.message.severity < trigger->least)
        return {};
    const auto &place = message.message.place;
    if (!trigger->place || trigger->place == place)
        return message.at;
    const bool isOnBus = trigger->place->isEmpty() && place && place->bus == trigger->place->bus;
    return isOnBus ? std::optional(message.at) : std::nullopt;
}

std::vector<RecordedPast> pastOf(Place place, const EncoderHistory &history, const TimeSpan &span)
{
    std::vector<RecordedPast> past;
    for (std::size_t i = 0; i < channelCount; ++i) {
        const auto channel = static_cast<Channel>(i);
        const MemoryHistory &its = history.of(channel);
        RecordedPast one{.place = place, .channel = channel, .samples = {}, .until = {}};
        if (const auto standing = its.at(span.from))
            one.samples.push_back({span.from, standing->value});
        its.forEach(span, [&](const Sample &sample) { one.samples.push_back(sample); });
        for (const History::Gap &gap : its.gaps(span))
            if (gap.from >= span.from)
                one.gaps.push_back(gap);
        if (one.samples.empty())
            continue;
        one.until = std::max(one.samples.back().at, one.gaps.empty() ? Instant(0) : one.gaps.back().from);
        past.push_back(std::move(one));
    }
    return past;
}

} // namespace codewheel
