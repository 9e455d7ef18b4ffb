// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace codewheel {

// Maps positions to pixel columns, zoom included. Position p fills the columns from x(p) to x(p + 1). Used by
// the cam ruler.
class RulerScale
{
public:
    // Positions 0..largest; a change shows all of them again.
    void setLargest(std::int64_t largest);
    void setColumns(int left, int width);

    std::int64_t largest() const { return m_largest; }
    std::int64_t total() const { return m_largest + 1; }
    double first() const { return m_first; } // position at the left end
    double shown() const { return m_shown; } // positions in sight
    bool showsAll() const { return m_shown >= static_cast<double>(total()); }

    double x(double position) const;
    double positionAt(double x) const; // may lie outside the range
    double positionsPerColumn() const;

    // 1, 2 or 5 times a power of ten, at least `apart` columns from one tick to the next.
    std::int64_t tickStep(double apart) const;
    std::vector<std::int64_t> ticks(std::int64_t step) const; // those in sight
    // What a mouse drag is rounded to: as fine as a column, but a round number.
    std::int64_t dragStep() const;

    void zoom(double factor, double aroundX); // factor > 1 shows fewer positions
    void showAll();
    void scrollTo(double first);
    void reveal(std::int64_t position); // scrolls no more than needed

private:
    void keepInRange();

    std::int64_t m_largest = 1;
    double m_first = 0;
    double m_shown = 2;
    int m_left = 0;
    int m_width = 1;
};

} // namespace codewheel
