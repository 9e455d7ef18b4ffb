// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_answer.h"
#include "kinds/esc/protocol/esc_command.h"

#include <vector>

// What an answer looks like on the wire (manual, "Return values from encoder"):
//
//     CR LF digits CR LF    of a read: 4 or 8 digits, or the text of the version
//     CR LF                 a write was executed
//     03 CR LF              the command is not known
//     05 CR LF              incomplete, or a value out of range
//
// There is no checksum: anything that differs by one byte is no answer.
namespace codewheel::esc {

inline constexpr char escape = '\x1B';
inline constexpr char lineEnd[] = "\r\n";
inline constexpr qsizetype lineEndSize = 2;
inline constexpr qsizetype shortestText = 4; // of the version; the manual has 25
inline constexpr qsizetype longestText = 40;
inline constexpr qsizetype longestAnswerSize = longestText + 2 * lineEndSize;

constexpr bool isHexDigit(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

constexpr bool isPrintable(char c)
{
    return c >= ' ' && c <= '~';
}

// Size of the longest answer that `shape` can get.
qsizetype answerSize(const CommandShape &shape);

// An answer and its place among the bytes.
struct Frame
{
    qsizetype begin = 0;
    qsizetype end = 0; // just past its last byte
    Answer answer;

    qsizetype size() const { return end - begin; }
};

// Every well-formed answer to a read with both its line ends, in order. Two may share a line end. Empty for a
// write.
std::vector<Frame> valuesIn(QByteArrayView bytes, const CommandShape &shape);

// What the whole of `bytes` says if it is an answer without a value: accepted (to a write only), 03 or 05.
std::optional<Answer> wordlessAnswer(QByteArrayView bytes, const CommandShape &shape);

} // namespace codewheel::esc
