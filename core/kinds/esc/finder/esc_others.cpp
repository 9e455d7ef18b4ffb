// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/finder/esc_others.h"

#include "kinds/esc/protocol/esc_frame.h"

#include <algorithm>

namespace codewheel {
namespace {

using RowKind = esc::EscLineRow::Kind;
using esc::Command;

QByteArray bytesOf(const EscLineExchange &exchange, RowKind kind)
{
    QByteArray bytes;
    for (const esc::EscLineRow &row : exchange.rows)
        if (row.kind == kind)
            bytes += row.bytes;
    return bytes;
}

// ESC and an address: what nobody but a master sends.
bool beginsRequest(const QByteArray &bytes)
{
    for (qsizetype at = bytes.indexOf(esc::escape); at >= 0 && at + 2 < bytes.size();
         at = bytes.indexOf(esc::escape, at + 1))
        if (esc::isHexDigit(bytes[at + 1]) && esc::isHexDigit(bytes[at + 2]))
            return true;
    return false;
}

// Digits that are fewer than they should be may be a damaged answer, a text cannot.
bool holdsAnswer(const QByteArray &bytes)
{
    const qsizetype longestNumber = esc::shapeOf(Command::serialNumber).digits;
    const auto isText = [&](const esc::Frame &frame) { return frame.answer.text.size() > longestNumber; };
    return !esc::valuesIn(bytes, esc::shapeOf(Command::serialNumber)).empty() ||
           !esc::valuesIn(bytes, esc::shapeOf(Command::deviceCode)).empty() ||
           std::ranges::any_of(esc::valuesIn(bytes, esc::shapeOf(Command::version)), isText);
}

// The digits of another value, where a text was asked for.
bool isNumber(const esc::Answer &answer)
{
    return answer.kind == esc::Answer::Kind::text && std::ranges::all_of(answer.text, esc::isHexDigit) &&
           (answer.text.size() == esc::shapeOf(Command::deviceCode).digits ||
            answer.text.size() == esc::shapeOf(Command::serialNumber).digits);
}

} // namespace

OtherBytes othersAround(const esc::Request &request, const EscLineExchange &exchange)
{
    const auto &answer = exchange.result.answer;
    const QByteArray late = bytesOf(exchange, RowKind::late);
    const QByteArray all = bytesOf(exchange, RowKind::garbage) + late;
    const qsizetype damaged = answer ? 0 : esc::answerSize(esc::shapeOf(request.command));
    return {all, late.size() > glitches || beginsRequest(all) || holdsAnswer(all) ||
                     all.size() > damaged + glitches || (answer && isNumber(*answer))};
}

OtherBytes othersAtMaster(const EscLineExchange &exchange, const QByteArray &after)
{
    const QByteArray inTime = bytesOf(exchange, RowKind::garbage);
    const QByteArray late = bytesOf(exchange, RowKind::late);
    const bool hasAnswer = exchange.result.answer || !inTime.isEmpty();
    const QByteArray all = inTime + late + after;
    return {all, beginsRequest(all) || (!hasAnswer && late.size() > glitches)};
}

} // namespace codewheel
