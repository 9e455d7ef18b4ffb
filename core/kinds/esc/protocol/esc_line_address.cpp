// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_line_address.h"

#include "vocabulary/hex.h"

namespace codewheel {
std::optional<EscLineAddress> EscLineAddress::fromWire(QStringView digits)
{
    constexpr qsizetype digitsOnWire = 2;
    const auto value = parseHexDigits(digits, digitsOnWire);
    if (!value || *value > last)
        return std::nullopt;
    return EscLineAddress{static_cast<std::uint8_t>(*value)};
}

EscLineAddress EscLineAddress::of(NodeId node)
{
    return addressTyped(node.toString()).value_or(master());
}

std::optional<EscLineAddress> addressTyped(QStringView text)
{
    constexpr QLatin1String prefix(EscLineAddress::prefix.data(), qsizetype{EscLineAddress::prefix.size()});
    if (text.startsWith(prefix))
        text = text.sliced(prefix.size());
    return text.size() == 2 ? EscLineAddress::fromWire(text) : std::nullopt;
}

} // namespace codewheel
