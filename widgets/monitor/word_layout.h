// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/word_form.h"

#include <QRect>

#include <optional>

namespace codewheel {

// Where the bits of a word stand: the highest left, in groups, each with its number above. Pure geometry, for
// WordView.
class WordLayout
{
public:
    static constexpr int matrixBitsPerRow = 8;

    // rows: 1, 2, or as many as a matrix has; factor: 1.5 with large controls.
    WordLayout(const WordForm &form, int rows, double factor, int numberHeight);

    const WordForm &form() const { return m_form; }
    int bits() const { return m_form.bits; }
    int rows() const { return m_rows; }
    int bitsPerRow() const { return m_form.bits / m_rows; }
    QSize size() const;

    QRect cell(int bit) const;
    QRect number(int bit) const;
    // By the cell or the number above it.
    std::optional<int> bitAt(QPoint point) const;

private:
    bool startsGroup(int bit) const { return (m_form.groupStarts >> bit & 1) != 0; }
    int left(int bit) const;
    int rowOf(int bit) const { return m_rows - 1 - bit / bitsPerRow(); }

    WordForm m_form;
    int m_rows;
    QSize m_cell;
    int m_numberHeight;
};

} // namespace codewheel
