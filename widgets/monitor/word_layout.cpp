// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_layout.h"

#include "widgets/look/grid.h"

namespace codewheel {

namespace {

constexpr int cellWidth = 22;
constexpr int cellHeight = 26;

} // namespace

WordLayout::WordLayout(const WordForm &form, int rows, double factor, int numberHeight)
    : m_form(form)
    , m_rows(rows)
    , m_cell(qRound(cellWidth * factor), qRound(cellHeight * factor))
    , m_numberHeight(numberHeight)
{}

QSize WordLayout::size() const
{
    const int width = left(bits() - bitsPerRow()) + m_cell.width();
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
            distance += m_cell.width() + (startsGroup(below + 1) ? grid::groupGap : 0);
        return distance;
    };
    return fromRight(bits() - 1) - fromRight(bit);
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
    for (int bit = 0; bit < bits(); ++bit)
        if (cell(bit).united(number(bit)).contains(point))
            return bit;
    return {};
}

} // namespace codewheel
