// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_request.h"

#include "kinds/esc/protocol/esc_frame.h"

#include <algorithm>

namespace codewheel::esc {
namespace {

constexpr qsizetype addressDigits = 2;

bool areHexDigits(QByteArrayView text)
{
    return std::ranges::all_of(text, isHexDigit);
}

// Data of a write: 1 to `digits` digits. A read has none.
bool isDataOf(QByteArrayView data, const CommandShape &shape)
{
    if (!shape.writes)
        return data.isEmpty();
    return !data.isEmpty() && data.size() <= shape.digits && areHexDigits(data);
}

} // namespace

QByteArray Request::text() const
{
    const CommandShape &shape = shapeOf(command);
    QByteArray text = to.onWire().toLatin1();
    text.append(shape.letters.data(), static_cast<qsizetype>(shape.letters.size()));
    if (shape.writes)
        text += QByteArray::number(data, 16).toUpper().rightJustified(shape.digits, '0');
    return text;
}

QByteArray Request::bytes() const
{
    return escape + text() + lineEnd;
}

std::optional<Request> parseRequest(QByteArrayView text)
{
    if (text.size() <= addressDigits || !areHexDigits(text.first(addressDigits)))
        return std::nullopt;
    const QByteArray upper = text.toByteArray().toUpper();
    const auto to = EscLineAddress::fromWire(QString::fromLatin1(upper.first(addressDigits)));
    const QByteArrayView rest = QByteArrayView(upper).sliced(addressDigits);
    const qsizetype letters = rest.front() == 'G' ? 2 : 1;
    if (!to || rest.size() < letters)
        return std::nullopt;
    const auto command = commandOf(rest.first(letters));
    if (!command || !isDataOf(rest.sliced(letters), shapeOf(*command)))
        return std::nullopt;
    return Request{*to, *command, rest.sliced(letters).toByteArray().toUInt(nullptr, 16)};
}

} // namespace codewheel::esc
