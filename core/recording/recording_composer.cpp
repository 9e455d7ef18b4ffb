// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_composer.h"

#include <QDateTime>

namespace codewheel {

std::size_t RecordingChanges::bytes() const
{
    std::size_t bytes = (devices.size() + channels.size() + summaries.size()) * sizeof(SummaryRow);
    for (const auto &[id, block] : blocks)
        bytes += sizeof block + static_cast<std::size_t>(block.data.capacity());
    for (const auto &[device, description] : descriptions)
        bytes += bytesOf(description);
    for (const auto &[id, message] : messages)
        bytes += sizeof message + 2 * static_cast<std::size_t>(message.second.arguments.size());
    for (const auto &[id, row] : traffic)
        bytes += bytesOf(row);
    return bytes + (notes.size() + losses.size() + clocks.size()) * sizeof(RecordingEntry);
}

void RecordingComposer::add(const RecordingEntry &entry)
{
    std::visit([this](const auto &what) { take(what); }, entry);
}

RecordingChanges &RecordingComposer::gathered()
{
    for (auto &[place, device] : m_devices)
        for (std::optional<ChannelBlocks> &channel : device.channels)
            if (channel)
                channel->write(m_changes);
    return m_changes;
}

RecordingComposer::Device &RecordingComposer::device(Place place)
{
    const auto found = m_devices.find(place);
    if (found != m_devices.end())
        return found->second;
    Device &made = m_devices[place];
    made.row = {std::ssize(m_devices), place, {}};
    m_changes.devices.insert_or_assign(made.row.id, made.row);
    return made;
}

ChannelBlocks &RecordingComposer::channel(Device &device, Channel channel)
{
    std::optional<ChannelBlocks> &blocks = device.channels.at(static_cast<std::size_t>(channel));
    if (!blocks) {
        blocks.emplace(m_nextChannel++, device.row.id, channel, m_nextBlock);
        m_changes.channels.insert_or_assign(blocks->row().id, blocks->row());
    }
    return *blocks;
}

void RecordingComposer::reach(Device &device, Instant at)
{
    device.row.until = std::max(device.row.until, at);
    m_changes.devices.insert_or_assign(device.row.id, device.row);
    reach(at);
}

void RecordingComposer::take(const RecordedBus &entry)
{
    m_changes.buses.push_back(entry);
    reach(m_until);
}

void RecordingComposer::take(const RecordedDescription &entry)
{
    m_changes.descriptions.emplace_back(device(entry.place).row.id, entry);
    reach(entry.since);
}

void RecordingComposer::take(const RecordedValues &entry)
{
    Device &shown = device(entry.place);
    for (const ShownValues &values : entry.values)
        add(shown, values);
    if (!entry.values.empty())
        reach(shown, entry.values.back().at);
}

void RecordingComposer::add(Device &device, const ShownValues &shown)
{
    device.shown.split(shown, [&](Channel which, const std::optional<std::int64_t> &value) {
        if (value)
            channel(device, which).append({shown.at, *value}, m_changes);
        else if (auto &blocks = device.channels.at(static_cast<std::size_t>(which)))
            blocks->interrupt(shown.at, m_changes);
    });
}

void RecordingComposer::take(const RecordedPast &entry)
{
    Device &shown = device(entry.place);
    ChannelBlocks &blocks = channel(shown, entry.channel);
    auto gap = entry.gaps.begin();
    const auto interruptUntil = [&](Instant at) {
        for (; gap != entry.gaps.end() && gap->from < at; ++gap)
            blocks.interrupt(gap->from, m_changes);
    };
    for (const Sample &sample : entry.samples) {
        interruptUntil(sample.at);
        blocks.append(sample, m_changes);
    }
    interruptUntil(Instant::max());
    reach(shown, entry.until);
}

void RecordingComposer::interrupt(Device &device, Instant at)
{
    for (std::optional<ChannelBlocks> &channel : device.channels)
        if (channel)
            channel->interrupt(at, m_changes);
    device.shown.interrupt();
}

void RecordingComposer::take(const RecordedInterruption &entry)
{
    const auto isMeant = [&entry](Place place) {
        return !entry.place || entry.place == place ||
               (entry.place->isEmpty() && entry.place->bus == place.bus);
    };
    for (auto &[place, device] : m_devices)
        if (isMeant(place))
            interrupt(device, entry.at);
    reach(entry.at);
}

void RecordingComposer::take(const RecordedMessage &entry)
{
    const auto stored = storedMessage(
        entry.message, QDateTime::fromMSecsSinceEpoch(
                           std::chrono::duration_cast<std::chrono::milliseconds>(entry.at).count(), Qt::UTC));
    m_changes.messages.emplace(m_nextRow++, std::pair(entry.at, stored));
    reach(entry.at);
}

void RecordingComposer::take(const RecordedTraffic &entry)
{
    m_changes.traffic.emplace_back(m_nextRow++, entry);
    reach(entry.at);
}

void RecordingComposer::take(const RecordedNote &entry)
{
    m_changes.notes.push_back(entry);
    reach(entry.at);
}

void RecordingComposer::take(const RecordedLoss &entry)
{
    m_changes.losses.emplace(m_nextRow++, entry);
    reach(entry.at);
}

void RecordingComposer::take(const RecordedClock &entry)
{
    const auto news = m_clock.news(entry);
    if (!news)
        return;
    m_changes.clocks.push_back(*news);
    reach(entry.at);
}

} // namespace codewheel
