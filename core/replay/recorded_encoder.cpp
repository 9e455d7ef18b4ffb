// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/recorded_encoder.h"

#include <algorithm>

namespace codewheel {

bool RecordedEncoder::Moment::isKnown() const
{
    return std::ranges::any_of(values, [](const auto &value) { return value.has_value(); });
}

Result<RecordedEncoder> RecordedEncoder::make(const RecordingReader &reader,
                                              const RecordingReader::Device &device)
{
    RecordedEncoder made(device);
    for (const Channel channel : device.channels) {
        auto its = reader.channel(device, channel);
        if (!its)
            return tl::unexpected(its.error());
        made.m_channels[static_cast<std::size_t>(channel)] = std::move(*its);
    }
    const auto descriptions = reader.descriptions(device);
    if (!descriptions)
        return tl::unexpected(descriptions.error());
    for (const RecordingReader::Description &one : *descriptions)
        made.m_described.push_back({one.since, recordedDeviceFromJson(one.json)});
    return made;
}

std::optional<TimeSpan> RecordedEncoder::span() const
{
    std::optional<TimeSpan> all;
    for (const auto &channel : m_channels)
        if (const auto its = channel ? channel->span() : std::nullopt)
            all = all ? TimeSpan{std::min(all->from, its->from), std::max(all->to, its->to)} : *its;
    return all;
}

template <class Value>
std::optional<Value> RecordedEncoder::take(const Result<std::optional<Value>> &read)
{
    if (read)
        return *read;
    m_problem = read.error();
    return std::nullopt;
}

RecordedEncoder::Moment RecordedEncoder::at(Instant at)
{
    Moment moment;
    for (std::size_t i = 0; i < m_channels.size(); ++i)
        if (m_channels[i])
            if (const auto sample = take(m_channels[i]->at(at)))
                moment.values[i] = sample->value;
    return moment;
}

const RecordedEncoder::Described *RecordedEncoder::describedAt(Instant at) const
{
    if (m_described.empty())
        return nullptr;
    const auto next = std::ranges::upper_bound(m_described, at, {}, &Described::since);
    return next == m_described.begin() ? &m_described.front() : &*std::prev(next);
}

// From the summaries of the recording, so that a bit that was set for one cycle is seen at any speed.
Word RecordedEncoder::changedBits(Channel channel, Instant from, Instant to)
{
    auto &its = m_channels[static_cast<std::size_t>(channel)];
    if (!its || to <= from)
        return 0;
    const auto between = take(its->summary({from + Instant(1), to + Instant(1)}));
    if (!between)
        return 0;
    const auto before = take(its->at(from));
    const Word stood = before ? static_cast<Word>(before->value) : between->always;
    return (between->ever | stood) & ~(between->always & stood);
}

std::optional<Instant> RecordedEncoder::next(Instant at)
{
    std::optional<Instant> nearest;
    for (auto &channel : m_channels)
        if (const auto sample = channel ? take(channel->after(at)) : std::nullopt)
            nearest = std::min(nearest.value_or(sample->at), sample->at);
    return nearest;
}

std::optional<Instant> RecordedEncoder::previous(Instant at)
{
    std::optional<Instant> nearest;
    for (auto &channel : m_channels)
        if (const auto sample = channel ? take(channel->before(at)) : std::nullopt)
            nearest = std::max(nearest.value_or(sample->at), sample->at);
    return nearest;
}

} // namespace codewheel
