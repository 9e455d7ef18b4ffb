// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/playback.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace codewheel {

Result<std::unique_ptr<Playback>> Playback::open(const QString &file)
{
    auto reader = RecordingReader::open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    std::unique_ptr<Playback> made(new Playback(std::move(*reader)));
    if (auto read = made->read(); !read)
        return tl::unexpected(read.error());
    made->m_position = made->m_span.from;
    return made;
}

// A recording may have samples of before it began.
Result<void> Playback::read()
{
    m_lookedAt = QFileInfo(m_reader.file()).lastModified();
    const auto head = m_reader.head();
    const auto clock = m_reader.clock();
    const auto buses = m_reader.buses();
    const auto devices = m_reader.devices();
    for (const Refusal *why : {head ? nullptr : &head.error(), clock ? nullptr : &clock.error(),
                               buses ? nullptr : &buses.error(), devices ? nullptr : &devices.error()})
        if (why != nullptr)
            return tl::unexpected(*why);
    std::vector<RecordedEncoder> encoders;
    std::optional<TimeSpan> span;
    for (const RecordingReader::Device &device : *devices) {
        auto encoder = RecordedEncoder::make(m_reader, device);
        if (!encoder)
            return tl::unexpected(encoder.error());
        if (const auto its = encoder->span())
            span = span ? TimeSpan{std::min(span->from, its->from), std::max(span->to, its->to)} : *its;
        encoders.push_back(std::move(*encoder));
    }
    m_head = *head;
    m_clock = *clock;
    m_buses = *buses;
    m_encoders = std::move(encoders);
    const Instant begun = std::max(head->begun, head->since);
    m_span =
        span ? TimeSpan{span->from, span->to - Instant(1)} : TimeSpan{begun, std::max(begun, head->until)};
    return {};
}

void Playback::lookAgain()
{
    const TimeSpan before = m_span;
    const bool hadEnded = m_head.hasEnded;
    const std::size_t encoders = m_encoders.size();
    if (!read() || m_encoders.size() < encoders)
        return;
    if (m_span != before || m_head.hasEnded != hadEnded)
        Q_EMIT stateChanged();
}

QDateTime Playback::dateTime(Instant at) const
{
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::floor<std::chrono::milliseconds>(m_clock.wall(at)).count());
}

void Playback::setFactor(double factor)
{
    if (factor <= 0 || std::exchange(m_factor, factor) == factor)
        return;
    Q_EMIT stateChanged();
}

bool Playback::isAtEnd(Direction direction) const
{
    return m_position == (direction == Direction::forward ? m_span.to : m_span.from);
}

void Playback::play(Direction direction)
{
    if (isAtEnd(direction))
        jumpTo(direction == Direction::forward ? m_span.from : m_span.to);
    m_isPlaying = true;
    m_direction = direction;
    Q_EMIT stateChanged();
}

void Playback::pause()
{
    if (std::exchange(m_isPlaying, false))
        Q_EMIT stateChanged();
}

void Playback::advance(Instant elapsed)
{
    if (!m_isPlaying || elapsed <= Instant(0))
        return;
    // The whole span at once at most, whatever the factor.
    const double way = std::min(static_cast<double>(elapsed.count()) * m_factor,
                                static_cast<double>((m_span.to - m_span.from).count()));
    const Instant by(std::max<Instant::rep>(1, std::llround(way)));
    if (m_direction == Direction::backward)
        ++m_jumps;
    moveTo(m_position + (m_direction == Direction::forward ? by : -by));
    if (isAtEnd(m_direction))
        pause();
}

void Playback::jumpTo(Instant at)
{
    if (std::clamp(at, m_span.from, m_span.to) == m_position)
        return;
    ++m_jumps;
    moveTo(at);
}

bool Playback::step(Direction direction, std::optional<Place> of)
{
    pause();
    const bool isForward = direction == Direction::forward;
    std::optional<Instant> nearest;
    for (RecordedEncoder &encoder : m_encoders) {
        if (of && encoder.place() != *of)
            continue;
        if (const auto its = isForward ? encoder.next(m_position) : encoder.previous(m_position))
            nearest = !nearest ? *its : isForward ? std::min(*nearest, *its) : std::max(*nearest, *its);
    }
    if (!nearest)
        return false;
    if (!isForward)
        ++m_jumps;
    moveTo(*nearest);
    return true;
}

void Playback::moveTo(Instant at)
{
    const Instant within = std::clamp(at, m_span.from, m_span.to);
    if (std::exchange(m_position, within) != within)
        Q_EMIT positionChanged();
}

std::optional<Refusal> Playback::problem() const
{
    for (const RecordedEncoder &encoder : m_encoders)
        if (encoder.problem())
            return encoder.problem();
    return {};
}

} // namespace codewheel
