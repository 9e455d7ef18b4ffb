// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_columns.h"

namespace codewheel {

// In two steps, since the length times the column may be more than a number holds.
Instant RecordingColumns::edge(std::size_t column) const
{
    const auto index = static_cast<std::int64_t>(column);
    const Instant rest = (m_span.to - m_span.from) % std::ssize(m_columns);
    return m_span.from + width() * index + rest * index / std::ssize(m_columns);
}

// Of a time in the span.
std::size_t RecordingColumns::columnAt(Instant at) const
{
    const auto length = static_cast<double>((m_span.to - m_span.from).count());
    const double share = static_cast<double>((at - m_span.from).count()) / length;
    auto column = std::min(static_cast<std::size_t>(share * static_cast<double>(m_columns.size())),
                           m_columns.size() - 1);
    while (column > 0 && edge(column) > at)
        --column;
    while (edge(column + 1) <= at)
        ++column;
    return column;
}

bool RecordingColumns::takes(const RecordedPiece &piece) const
{
    if (isNarrow(piece.length))
        return true;
    const Instant end = piece.from + piece.length;
    return contains(piece.from) && contains(end) && columnAt(piece.from) == columnAt(end);
}

void RecordingColumns::add(const RecordedPiece &piece)
{
    const Instant at = std::max(piece.from, m_since);
    if (contains(at) && piece.from + piece.length >= at)
        add(at, piece.column, piece.samples);
}

void RecordingColumns::add(const Sample &sample, bool isAfterGap)
{
    if (!contains(sample.at))
        return;
    const auto word = static_cast<std::uint32_t>(sample.value);
    add(sample.at, {{{sample.value, sample.value}, word, word}, sample.value, sample.value, isAfterGap}, 1);
}

void RecordingColumns::add(Instant at, const History::Column &column, std::uint64_t samples)
{
    m_samples += samples;
    auto &there = m_columns[columnAt(at)];
    if (!there) {
        there = column;
        return;
    }
    there->summary.include(column.summary);
    there->last = column.last;
    there->hasGap = there->hasGap || column.hasGap;
}

} // namespace codewheel
