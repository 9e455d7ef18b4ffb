// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/track.h"

#include <functional>
#include <vector>

namespace codewheel {

class Histories;

// A track as a column of a file.
struct TrendColumn
{
    Track track;
    QString name{}; // of the encoder, such as its station; empty: none
    TrackScale scale{};
    Instant shift{};   // of a recording that is laid on others: how much later than recorded its times are
    QString busName{}; // of a recording, whose bus has a number of this session alone; empty: by its number

    // "1.0 Hoist: speed [rpm]", "3/1.0 OUT.25": the same in every language, and by its place never that of
    // another track.
    QString title() const;

    friend bool operator==(const TrendColumn &, const TrendColumn &) = default;
};

// What of a trend goes into a file, both ends of the span included.
struct TrendExtract
{
    std::vector<TrendColumn> columns;
    TimeSpan span; // with the shifts

    // That of all columns; its times in the file are then those of the recording. 0: they differ, or there is
    // none.
    Instant commonShift() const;
    // Of a column, and how much later than recorded its times are in the file.
    Instant remainingShift(const TrendColumn &column) const { return column.shift - commonShift(); }
    QString title(const TrendColumn &column) const; // says what is left of the shift
};

// Where the samples of a track are; null: there are none. Asked again for every piece of a file, since what
// is kept grows, and goes, while the file is written.
using HistoryOf = std::function<const History *(const Track &)>;
HistoryOf historyOf(const Histories &histories); // which outlive it

} // namespace codewheel
