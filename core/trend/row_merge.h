// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "trend/trend_extract.h"

namespace codewheel {

// The samples of several tracks as the rows of one table. There is a row for each moment at which one of them
// has a sample, so that no spike is lost, and for each at which one of them becomes unknown; and one at
// either end of the span, if anything stands there. A cell holds what its track had then, not only what is
// new.
class RowMerge
{
public:
    using Cells = std::span<const std::optional<std::int64_t>>; // as kept; nothing: it was not known
    using TakeRow = std::function<void(Instant at, Cells cells)>;

    // Some thousand samples are taken at once, which takes milliseconds.
    RowMerge(const TrendExtract &extract, HistoryOf historyOf);

    // Hands out the next rows, which may be none. False: there are no more.
    bool next(const TakeRow &take);
    double part() const; // of the span that is done, 0..1

private:
    struct Event
    {
        Instant at;
        std::optional<std::int64_t> value; // nothing: a gap begins
    };
    struct Column
    {
        Track track;
        std::vector<Event> events{}; // of the stretch at hand, oldest first
        std::size_t next = 0;
        Instant knownUntil = Instant::min(); // what follows the newest sample nobody knows yet
        std::optional<std::int64_t> value{};

        void load(const History *history, const TimeSpan &stretch);
        void addGaps(const History &history, const TimeSpan &stretch);
    };

    Instant endOfStretch() const;
    std::size_t samplesIn(const TimeSpan &span) const;
    std::optional<Instant> nextRow() const;
    void open(const TakeRow &take);
    void close(const TakeRow &take);
    void give(Instant at, const TakeRow &take);

    HistoryOf m_historyOf;
    TimeSpan m_span;
    Instant m_reached; // the rows before are done
    Instant m_stretch; // the length of the one before: mostly that of the next
    std::vector<Column> m_columns;
    std::vector<std::optional<std::int64_t>> m_cells;
    bool m_isOpen = false;
    bool m_isDone = false;
};

} // namespace codewheel
