// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_archive.h"

namespace codewheel {
namespace {

constexpr int mostMarks = 10'000; // of messages, and of notes

} // namespace

RecordingArchive::RecordingArchive(RecordingReader reader, BusesHere buses)
    : m_reader(std::move(reader))
    , m_buses(std::move(buses))
    , m_statistics(m_reader.file())
{
    connect(&m_statistics, &RecordedStatistics::ready, this, &RecordingArchive::statisticsReady);
}

Result<std::unique_ptr<RecordingArchive>> RecordingArchive::open(const QString &file, const BusesHere &buses)
{
    auto reader = RecordingReader::open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    std::unique_ptr<RecordingArchive> archive(new RecordingArchive(std::move(*reader), buses));
    auto histories = archive->readHistories();
    auto marks = archive->readMarks();
    if (!histories || !marks)
        return tl::unexpected(histories ? marks.error() : histories.error());
    archive->m_histories = std::move(*histories);
    archive->m_marks = std::move(*marks);
    return archive;
}

void RecordingArchive::lookAgain()
{
    auto histories = readHistories();
    auto marks = readMarks();
    if (!histories || !marks)
        return;
    m_histories.swap(*histories); // those of before are there until nobody shows them any more
    m_marks = std::move(*marks);
    m_statistics.forget();
    Q_EMIT changed();
}

Result<RecordingArchive::ByPlace> RecordingArchive::readHistories() const
{
    const auto devices = m_reader.devices();
    if (!devices)
        return tl::unexpected(devices.error());
    ByPlace all;
    for (const RecordingReader::Device &device : *devices) {
        auto &histories = all[placeHere(device.place)];
        for (const Channel kind : device.channels) {
            auto channel = m_reader.channel(device, kind);
            if (!channel)
                return tl::unexpected(channel.error());
            histories.try_emplace(kind, std::move(*channel), RecordedKey{device.id, kind}, *this);
        }
    }
    return all;
}

// A message without a place is of the program that recorded it.
Result<std::vector<Mark>> RecordingArchive::readMarks() const
{
    constexpr TimeSpan always{Instant(0), Instant::max()};
    const auto messages = m_reader.messages(always, mostMarks);
    const auto notes = m_reader.notes(always, mostMarks);
    if (!messages || !notes)
        return tl::unexpected(messages ? notes.error() : messages.error());
    std::vector<Mark> marks;
    for (const RecordingReader::StoredAt &stored : *messages) {
        auto message = messageOf(stored.message);
        if (!message || !message->place)
            continue;
        message->place = placeHere(*message->place);
        marks.push_back({stored.at, message->place, *message});
    }
    for (const RecordedNote &note : *notes)
        marks.push_back({note.at, {}, note.text});
    std::ranges::stable_sort(marks, {}, &Mark::at);
    return marks;
}

Place RecordingArchive::placeHere(Place recorded) const
{
    const auto here = m_buses.find(recorded.bus);
    return {here == m_buses.end() ? recorded.bus : here->second, recorded.node};
}

std::vector<Place> RecordingArchive::places() const
{
    std::vector<Place> places;
    for (const auto &[place, histories] : m_histories)
        places.push_back(place);
    return places;
}

const History *RecordingArchive::of(Place place, Channel channel) const
{
    const auto device = m_histories.find(place);
    if (device == m_histories.end())
        return nullptr;
    const auto found = device->second.find(channel);
    return found == device->second.end() ? nullptr : &found->second;
}

std::optional<TimeSpan> RecordingArchive::span() const
{
    std::optional<TimeSpan> all;
    for (const auto &[place, histories] : m_histories)
        for (const auto &[channel, history] : histories)
            if (const auto its = history.span())
                all = all ? TimeSpan{std::min(all->from, its->from), std::max(all->to, its->to)} : *its;
    return all;
}

std::vector<Mark> RecordingArchive::marks() const
{
    std::vector<Mark> marks = m_marks;
    for (Mark &mark : marks)
        mark.at += shift();
    return marks;
}

std::optional<Instant> RecordingArchive::played() const
{
    return m_played ? std::optional(*m_played + shift()) : std::nullopt;
}

std::optional<History::Statistics> RecordingArchive::slowStatistics(const RecordedKey &key,
                                                                    const TimeSpan &recorded) const
{
    return m_statistics.of(key, recorded);
}

void RecordingArchive::tell(const Refusal &why) const
{
    if (m_told != why)
        Q_EMIT troubled(*(m_told = why));
}

void RecordingArchive::tellDamage(const std::optional<Refusal> &damage) const
{
    if (damage)
        tell(*damage);
}

} // namespace codewheel
