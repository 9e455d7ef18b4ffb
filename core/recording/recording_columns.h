// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/history.h"
#include "recording/recording_changes.h"

namespace codewheel {

// Puts pieces and samples, oldest first, into the columns of a picture, as History::columns() does.
class RecordingColumns
{
public:
    using Columns = History::Columns;

    // What is older than `since` is left out.
    RecordingColumns(const TimeSpan &span, std::size_t count, Instant since)
        : m_span(span)
        , m_since(std::max(span.from, since))
        , m_columns(count)
    {}

    Instant width() const { return (m_span.to - m_span.from) / static_cast<std::int64_t>(m_columns.size()); }
    // A piece that is this narrow is put where it begins, although it may reach into the next column, and
    // into the first one if it begins before that: nobody sees half a pixel.
    bool isNarrow(Instant length) const { return length <= width() / 2; }
    // Whether it can be put as a whole: otherwise its samples have to be.
    bool takes(const RecordedPiece &piece) const;
    void add(const RecordedPiece &piece);
    void add(const Sample &sample, bool isAfterGap);

    std::uint64_t samples() const { return m_samples; } // that are in them, or a few more
    Columns take() { return std::move(m_columns); }

private:
    bool contains(Instant at) const { return at >= m_since && at < m_span.to; }
    Instant edge(std::size_t column) const;
    std::size_t columnAt(Instant at) const;
    void add(Instant at, const History::Column &column, std::uint64_t samples);

    TimeSpan m_span;
    Instant m_since;
    Columns m_columns;
    std::uint64_t m_samples = 0;
};

} // namespace codewheel
