// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/mark.h"
#include "history/track.h"

#include <QColor>

#include <vector>

namespace codewheel {

// One curve, and where its samples are; it outlives the scene or is null.
struct TrendCurve
{
    Track track;
    TrackScale scale;
    const History *history = nullptr;
    QString name;
    QColor color{};

    double valueOf(std::int64_t sample, Instant then) const
    {
        return static_cast<double>(track.of(sample)) * scale.factor(track.channel, then);
    }
    double valueOf(const Sample &sample) const { return valueOf(sample.value, sample.at); }
};

// Curves that share an axis; a single bit has a narrow lane of its own.
struct TrendLane
{
    std::vector<TrendCurve> curves;
    QString unit;
    double low = 0; // of the axis
    double high = 1;

    bool isLogic() const { return !curves.empty() && curves.front().track.bit.has_value(); }
};

// All that a chart shows at a moment.
struct TrendScene
{
    std::vector<TrendLane> lanes; // from top to bottom
    TimeSpan span{};
    std::vector<Mark> marks; // within the span, oldest first
    std::array<std::optional<Instant>, 2> cursors{};
    std::size_t chosenCursor = 0;    // the one that keys move
    std::optional<Instant> played{}; // the moment of a recording that its encoders show
};

} // namespace codewheel
