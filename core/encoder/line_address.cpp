// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/line_address.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isHexDigit(QChar c)
{
    return (c >= u'0' && c <= u'9') || (c >= u'A' && c <= u'F') || (c >= u'a' && c <= u'f');
}

} // namespace

QString LineAddress::onWire() const
{
    return QStringLiteral("%1").arg(value, 2, 16, QLatin1Char('0')).toUpper();
}

QString LineAddress::shown() const
{
    return QStringLiteral("%1h (%2)").arg(onWire()).arg(value);
}

std::optional<LineAddress> LineAddress::fromWire(QStringView digits)
{
    if (digits.isEmpty() || digits.size() > 2 || !std::all_of(digits.begin(), digits.end(), isHexDigit))
        return std::nullopt;
    const uint value = digits.toUInt(nullptr, 16);
    if (value > last)
        return std::nullopt;
    return LineAddress{static_cast<std::uint8_t>(value)};
}

} // namespace codewheel
