// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_layout.h"

#include "widgets/look/grid.h"

namespace codewheel {

namespace {

constexpr int cellWidth = 22;
constexpr int cellHeight = 26;
// So that a row of 32 bits fits beside the panels in a window 1280 pixels wide.
constexpr int narrowCellWidth = 18;
constexpr int narrowGroupGap = grid::unit;
constexpr int widestNarrowRow = 16; // bits; longer rows are narrow
constexpr int wordGap = 2;

} // namespace

WordLayout::WordLayout(const WordForm &form, int words, int rows, const Room &room)
    : m_form(form)
    , m_words(words)
    , m_rows(rows)
    , m_room(room)
{
    const bool isNarrow = room.isTight || bitsPerRow() > widestNarrowRow;
    m_cell = {qRound((isNarrow ? narrowCellWidth : cellWidth) * room.factor),
              qRound(cellHeight * room.factor)};
    m_groupGap = isNarrow ? narrowGroupGap : grid::groupGap;
}

int WordLayout::rowHeight() const
{
    return m_room.numberHeight + m_words * m_cell.height() + (m_words - 1) * wordGap;
}

QSize WordLayout::size() const
{
    const int width = left(bits() - bitsPerRow()) + m_cell.width();
    return {width, m_rows * rowHeight() + (m_rows - 1) * grid::unit};
}

// Rows are right-aligned, so that their nibbles line up.
int WordLayout::left(int bit) const
{
    const auto fromRight = [this](int of) {
        const int first = of - of % bitsPerRow();
        int distance = 0;
        for (int below = first; below < of; ++below)
            distance += m_cell.width() + (startsGroup(below + 1) ? m_groupGap : 0);
        return distance;
    };
    return m_room.captionWidth + fromRight(bits() - 1) - fromRight(bit);
}

int WordLayout::top(int word, int row) const
{
    return row * (rowHeight() + grid::unit) + m_room.numberHeight + word * (m_cell.height() + wordGap);
}

QRect WordLayout::cell(WordBit bit) const
{
    return {QPoint(left(bit.bit), top(bit.word, rowOf(bit.bit))), m_cell};
}

QRect WordLayout::number(int bit) const
{
    const QRect below = cell({0, bit});
    return {below.left(), below.top() - m_room.numberHeight, below.width(), m_room.numberHeight};
}

QRect WordLayout::caption(int word, int row) const
{
    return {0, top(word, row), m_room.captionWidth, m_cell.height()};
}

std::optional<WordBit> WordLayout::bitAt(QPoint point) const
{
    for (int bit = 0; bit < bits(); ++bit) {
        if (number(bit).contains(point))
            return WordBit{0, bit};
        for (int word = 0; word < m_words; ++word)
            if (cell({word, bit}).contains(point))
                return WordBit{word, bit};
    }
    return {};
}

} // namespace codewheel
