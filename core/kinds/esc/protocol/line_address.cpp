// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/line_address.h"

#include "vocabulary/hex.h"

namespace codewheel {
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
    constexpr qsizetype digitsOnWire = 2;
    const auto value = parseHexDigits(digits, digitsOnWire);
    if (!value || *value > last)
        return std::nullopt;
    return LineAddress{static_cast<std::uint8_t>(*value)};
}

LineAddress LineAddress::of(NodeId node)
{
    return addressTyped(node.toString()).value_or(master());
}

std::optional<LineAddress> addressTyped(QStringView text)
{
    constexpr QLatin1String prefix(LineAddress::prefix.data(), qsizetype{LineAddress::prefix.size()});
    if (text.startsWith(prefix))
        text = text.sliced(prefix.size());
    return text.size() == 2 ? LineAddress::fromWire(text) : std::nullopt;
}

} // namespace codewheel
