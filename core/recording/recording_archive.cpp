// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_archive.h"

#include "recording/recorded_device.h"

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
    auto contents = archive->read();
    if (!contents)
        return tl::unexpected(contents.error());
    archive->m_contents = std::move(*contents);
    return archive;
}

void RecordingArchive::lookAgain()
{
    auto contents = read();
    if (!contents)
        return;
    m_contents = std::move(*contents);
    const Histories before = std::exchange(m_histories, {}); // there until nobody shows them any more
    m_statistics.forget();
    Q_EMIT changed();
}

Result<RecordingArchive::Contents> RecordingArchive::read() const
{
    const auto devices = m_reader.devices();
    const auto span = m_reader.span();
    auto marks = readMarks();
    if (!devices || !span)
        return tl::unexpected(devices ? span.error() : devices.error());
    if (!marks)
        return tl::unexpected(marks.error());
    Contents contents{.devices = {}, .known = {}, .span = *span, .marks = std::move(*marks)};
    for (const RecordingReader::Device &device : *devices) {
        auto known = readKnown(device);
        if (!known)
            return tl::unexpected(known.error());
        contents.known.emplace(placeHere(device.place), std::move(*known));
        contents.devices.emplace(placeHere(device.place), device);
    }
    return contents;
}

Result<std::vector<ValuesSince>> RecordingArchive::readKnown(const RecordingReader::Device &device) const
{
    const auto descriptions = m_reader.descriptions(device);
    if (!descriptions)
        return tl::unexpected(descriptions.error());
    std::vector<ValuesSince> known;
    for (const RecordingReader::Description &one : *descriptions)
        known.push_back({one.since, recordedDeviceFromJson(one.json).known});
    return known;
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
    for (const auto &[place, device] : m_contents.devices)
        places.push_back(place);
    return places;
}

const History *RecordingArchive::of(Place place, Channel channel) const
{
    const auto device = m_contents.devices.find(place);
    if (device == m_contents.devices.end() || std::ranges::count(device->second.channels, channel) == 0)
        return nullptr;
    auto &history = m_histories[{place, channel}];
    if (history)
        return history.get();
    auto its = m_reader.channel(device->second, channel);
    if (!its) {
        tell(its.error());
        return nullptr;
    }
    history =
        std::make_unique<RecordedHistory>(std::move(*its), RecordedKey{device->second.id, channel}, *this);
    return history.get();
}

std::optional<TimeSpan> RecordingArchive::span() const
{
    return m_contents.span
               ? std::optional(TimeSpan{m_contents.span->from + shift(), m_contents.span->to + shift()})
               : std::nullopt;
}

std::vector<Mark> RecordingArchive::marks() const
{
    std::vector<Mark> marks = m_contents.marks;
    for (Mark &mark : marks)
        mark.at += shift();
    return marks;
}

std::vector<ValuesSince> RecordingArchive::known(Place place) const
{
    const auto found = m_contents.known.find(place);
    return found == m_contents.known.end() ? std::vector<ValuesSince>() : found->second;
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
