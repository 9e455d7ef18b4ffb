// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/sample.h"

namespace codewheel {

// Which part of the time a trend shows, and whether it follows what comes. Zooms and scrolls; never shorter
// than can be told apart, nor longer or elsewhere than there is something to see.
class SeenTime
{
public:
    static constexpr Instant shortest = std::chrono::microseconds(100);
    static constexpr Instant usual = std::chrono::seconds(60);

    const TimeSpan &span() const { return m_span; }
    Instant length() const { return m_span.to - m_span.from; }
    bool follows() const { return m_follows; }

    // How many columns of pixels a curve has. What follows keeps to whole ones, so that a curve does not
    // change its form while it moves.
    void setColumns(int columns) { m_columns = std::max(columns, 1); }
    // All there is. While it follows, the newest of it stands at the right: what is older than `newest`.
    void setAll(const TimeSpan &all, Instant newest);
    void setAll(const TimeSpan &all) { setAll(all, all.to); }
    const TimeSpan &all() const { return m_all; }
    void follow();
    void show(const TimeSpan &span);
    void showAll();
    void scroll(double lengths); // positive: to later times
    // Larger than 1: more is seen. `at`: the part of the length that stays where it is, 0 at the left.
    void zoom(double factor, double at);

private:
    Instant times(double lengths) const;

    TimeSpan m_all{};
    Instant m_newest{};
    TimeSpan m_span{{}, usual};
    int m_columns = 1'000;
    bool m_follows = true;
};

} // namespace codewheel
