// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_frame.h"

#include <algorithm>

namespace codewheel::esc {
namespace {

using AnswerKind = Answer::Kind;

// Text (the version) has no digits.
std::optional<Answer> contentOf(QByteArrayView text, const CommandShape &shape)
{
    if (shape.digits > 0) {
        if (text.size() != shape.digits || !std::ranges::all_of(text, isHexDigit))
            return std::nullopt;
        return Answer{AnswerKind::value, text.toByteArray().toUInt(nullptr, 16), text.toByteArray()};
    }
    if (text.size() < shortestText || text.size() > longestText || !std::ranges::all_of(text, isPrintable))
        return std::nullopt;
    return Answer{AnswerKind::text, 0, text.toByteArray()};
}

} // namespace

qsizetype answerSize(const CommandShape &shape)
{
    constexpr qsizetype errorSize = 2 + lineEndSize;
    if (shape.writes)
        return errorSize;
    return (shape.digits > 0 ? shape.digits : longestText) + 2 * lineEndSize;
}

std::vector<Frame> valuesIn(QByteArrayView bytes, const CommandShape &shape)
{
    std::vector<Frame> frames;
    if (shape.writes)
        return frames;
    for (qsizetype begin = bytes.indexOf(lineEnd); begin >= 0;) {
        const qsizetype content = begin + lineEndSize;
        const qsizetype next = bytes.indexOf(lineEnd, content);
        if (next < 0)
            break;
        if (auto answer = contentOf(bytes.sliced(content, next - content), shape))
            frames.push_back({begin, next + lineEndSize, std::move(*answer)});
        begin = next;
    }
    return frames;
}

std::optional<Answer> wordlessAnswer(QByteArrayView bytes, const CommandShape &shape)
{
    if (shape.writes && bytes == QByteArrayView(lineEnd))
        return Answer{AnswerKind::accepted, 0, {}};
    if (bytes == QByteArrayView("03\r\n"))
        return Answer{AnswerKind::unknownCommand, 0, "03"};
    if (bytes == QByteArrayView("05\r\n"))
        return Answer{AnswerKind::outOfRange, 0, "05"};
    return std::nullopt;
}

} // namespace codewheel::esc
