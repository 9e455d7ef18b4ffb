// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_layout.h"

#include "widgets/look/grid.h"

namespace codewheel {

namespace {

constexpr int cellWidth = 22;
constexpr int cellHeight = 26;

// Groups that start at this bit, counted from bit 0 up: the right end of each row of groups.
bool startsGroup(int bit, int bits)
{
    if (bits == 32 && bit > 24)
        return bit == 25 || bit == 29;
    return bit % 4 == 0;
}

} // namespace

WordLayout::WordLayout(int bits, int rows, double factor, int numberHeight)
    : m_bits(bits)
    , m_rows(rows)
    , m_cell(qRound(cellWidth * factor), qRound(cellHeight * factor))
    , m_numberHeight(numberHeight)
{}

QSize WordLayout::size() const
{
    const int width = left(m_bits - bitsPerRow()) + m_cell.width();
    const int rowHeight = m_numberHeight + m_cell.height();
    return {width, m_rows * rowHeight + (m_rows - 1) * grid::unit};
}

// Rows are flush right, so that the nibbles of both stand above each other.
int WordLayout::left(int bit) const
{
    const auto fromRight = [this](int of) {
        const int first = of - of % bitsPerRow();
        int distance = 0;
        for (int below = first; below < of; ++below)
            distance += m_cell.width() + (startsGroup(below + 1, m_bits) ? grid::groupGap : 0);
        return distance;
    };
    return fromRight(m_bits - 1) - fromRight(bit);
}

QRect WordLayout::cell(int bit) const
{
    const int top = rowOf(bit) * (m_numberHeight + m_cell.height() + grid::unit) + m_numberHeight;
    return {QPoint(left(bit), top), m_cell};
}

QRect WordLayout::number(int bit) const
{
    const QRect below = cell(bit);
    return {below.left(), below.top() - m_numberHeight, below.width(), m_numberHeight};
}

std::optional<int> WordLayout::bitAt(QPoint point) const
{
    for (int bit = 0; bit < m_bits; ++bit)
        if (cell(bit).united(number(bit)).contains(point))
            return bit;
    return {};
}

} // namespace codewheel
