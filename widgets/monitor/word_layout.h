// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include <optional>

namespace codewheel {

// Where the bits of a word stand: the highest left, status D31..D29 | parameter number D28..D25 | data by
// nibbles, each with its number above. Pure geometry, for WordView.
class WordLayout
{
public:
    static constexpr int matrixBitsPerRow = 8;

    // bits: 16 or 32; rows: 1, 2, or as many as a matrix has; factor: 1.5 with large controls.
    WordLayout(int bits, int rows, double factor, int numberHeight);

    int bits() const { return m_bits; }
    int rows() const { return m_rows; }
    int bitsPerRow() const { return m_bits / m_rows; }
    QSize cellSize() const { return m_cell; }
    QSize size() const;

    QRect cell(int bit) const;
    QRect number(int bit) const;
    // By the cell or the number above it.
    std::optional<int> bitAt(QPoint point) const;

private:
    int left(int bit) const;
    int rowOf(int bit) const { return m_rows - 1 - bit / bitsPerRow(); }

    int m_bits;
    int m_rows;
    QSize m_cell;
    int m_numberHeight;
};

} // namespace codewheel
