// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/word_form.h"

#include <QMetaType>
#include <QRect>

#include <optional>

namespace codewheel {

// A bit in one of several words shown one above the other: 0 is the upper word.
struct WordBit
{
    int word = 0;
    int bit = 0;

    friend bool operator==(const WordBit &, const WordBit &) = default;
};

// The geometry of words shown bit under bit: the highest bit left, in groups, with one line of numbers above
// them. If they take several rows, each row has its part of every word. Used by WordView.
class WordLayout
{
public:
    static constexpr int matrixBitsPerRow = 8;

    // The room around the cells, in pixels.
    struct Room
    {
        double factor = 1;    // of the cells: 1.5 with large controls
        bool isTight = false; // the cells are as narrow as in a row of 32
        int numberHeight = 0; // of the numbers above them
        int captionWidth = 0; // of the names of the words, left of them
    };

    // rows: 1, 2, or as many as the matrix has.
    WordLayout(const WordForm &form, int words, int rows, const Room &room);

    const WordForm &form() const { return m_form; }
    int bits() const { return m_form.bits; }
    int words() const { return m_words; }
    int rows() const { return m_rows; }
    int bitsPerRow() const { return m_form.bits / m_rows; }
    QSize size() const;

    QRect cell(WordBit bit) const;
    QRect number(int bit) const;
    QRect caption(int word, int row) const;
    // By its cell, or by its number, which counts as the upper word.
    std::optional<WordBit> bitAt(QPoint point) const;

private:
    bool startsGroup(int bit) const { return (m_form.groupStarts >> bit & 1) != 0; }
    int left(int bit) const;
    int rowOf(int bit) const { return m_rows - 1 - bit / bitsPerRow(); }
    int rowHeight() const;
    int top(int word, int row) const;

    WordForm m_form;
    int m_words;
    int m_rows;
    Room m_room;
    QSize m_cell;
    int m_groupGap;
};

} // namespace codewheel
