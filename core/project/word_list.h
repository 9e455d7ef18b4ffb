// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

#include <QString>

#include <tl/expected.hpp>
#include <vector>

namespace codewheel {

// The words of a sequence, and how long a word is held that is not acknowledged.
struct WordList
{
    static constexpr int longestHold = 10'000; // cycles
    static constexpr std::size_t mostWords = 1'000;

    std::vector<Word> words;
    int holdCycles = 3;

    friend bool operator==(const WordList &, const WordList &) = default;
};

// What is wrong with a text or a file, as a sentence that names the line.
template <typename T>
using Parsed = tl::expected<T, QString>;

// A column of hexadecimal words as pasted from an editor or a spreadsheet: one word per line, in the first
// cell that is not empty; quotes around a cell and empty lines are ignored. All or nothing.
Parsed<std::vector<Word>> parseColumn(const QString &text);

// docs/sequence-files.md
QByteArray sequenceToJson(const WordList &list);
Parsed<WordList> sequenceFromJson(const QByteArray &json);

} // namespace codewheel
