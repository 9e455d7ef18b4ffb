// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cstdint>
#include <deque>
#include <optional>

namespace codewheel {

// How fast positions change, by the time on the bus of the cycles or answers they came with. It is smoothed
// over half a second, and where the position changes seldom over as many changes as it takes to tell a speed.
// A position further away than a shaft can have turned (a preset, another scaling), a gap in time, and a turn
// that may have been missed start it anew: none of them is a speed. Used by the drivers, which see every
// position; those that are shown are too few.
class PositionSpeed
{
public:
    struct Scale
    {
        double stepsPerTurn = 0;             // of a rod: steps per 100 mm
        std::optional<std::int64_t> total{}; // the number of positions; empty: unknown, or there is no wrap

        friend bool operator==(const Scale &, const Scale &) = default;
    };

    static constexpr Instant longestGap = std::chrono::seconds(2);

    // Empty: unknown, and so is the speed.
    void setScale(const std::optional<Scale> &scale);
    void restart();
    void observe(Instant at, std::int64_t position);
    // The speed after this position; without a position it starts anew.
    std::optional<double> after(const std::optional<std::int64_t> &position, Instant at);
    std::optional<double> stepsPerSecond() const;
    // The last positions came so late that the shaft may have made a whole turn between two: that is why
    // there is no speed.
    bool mayMissTurns() const { return m_mayMissTurns; }

private:
    struct Sample
    {
        Instant at{};
        std::int64_t position = 0;
        std::int64_t way = 0; // steps since the start, wraps undone
    };

    void begin(const Sample &first);
    std::optional<double> recently() const;
    std::optional<std::int64_t> wayTo(std::int64_t position, double seconds);
    void noteChange();
    void forgetOldChanges();
    double slope() const;

    std::optional<Scale> m_scale;
    std::optional<Sample> m_last;
    Sample m_newer; // some milliseconds old, m_older as many more: for recently()
    Sample m_older;
    Instant m_changedAt{};        // or started
    std::deque<Sample> m_changes; // when the position had just changed
    double m_slope = 0;           // of them
    bool m_mayMissTurns = false;
};

} // namespace codewheel
