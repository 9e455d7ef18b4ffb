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

    // "1.0 Hoist: speed [rpm]", "3/1.0 OUT.25": the same in every language, and by its place never that of
    // another track.
    QString title() const;

    friend bool operator==(const TrendColumn &, const TrendColumn &) = default;
};

// What of a trend goes into a file, both ends of the span included.
struct TrendExtract
{
    std::vector<TrendColumn> columns;
    TimeSpan span;
};

// Where the samples of a track are; null: there are none. Asked again for every piece of a file, since what
// is kept grows, and goes, while the file is written.
using HistoryOf = std::function<const History *(const Track &)>;
HistoryOf historyOf(const Histories &histories); // which outlive it

} // namespace codewheel
