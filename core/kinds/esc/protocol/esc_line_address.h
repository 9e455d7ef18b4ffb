// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QString>

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace codewheel {

// The address of a device on a serial line with the Kübler ESC protocol: 1..31, or 0 for the master address,
// which any device answers (manual, "Masteraddress: 00"). On the wire it is two hexadecimal digits.
struct EscLineAddress
{
    std::uint8_t value = 0;

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const EscLineAddress &, const EscLineAddress &) = default;

    static constexpr std::uint8_t last = 31;
    static constexpr EscLineAddress master() { return {0}; }
    bool isMaster() const { return value == 0; }
    bool isDevice() const { return value >= 1 && value <= last; }

    static constexpr std::string_view prefix = "esc:"; // of a place and of a link

    // The two digits on the wire: "12".
    QString onWire() const { return QStringLiteral("%1").arg(value, 2, 16, QLatin1Char('0')).toUpper(); }
    // Both notations, as the window shows it: "12h (18)".
    QString shown() const { return QStringLiteral("%1h (%2)").arg(onWire()).arg(value); }
    // One or two hexadecimal digits, 0..1Fh; empty for anything else.
    static std::optional<EscLineAddress> fromWire(QStringView digits);

    // Its place: as on the wire, with a prefix that distinguishes it from a device number: "esc:12" is 12h =
    // 18. An encoder that is alone on its line may also be at "esc:00".
    constexpr NodeId node() const
    {
        constexpr std::string_view digits = "0123456789ABCDEF";
        std::array<char, prefix.size() + 2> text{};
        std::ranges::copy(prefix, text.begin());
        text.at(prefix.size()) = digits.at(value / digits.size());
        text.back() = digits.at(value % digits.size());
        return NodeId({text.data(), text.size()});
    }
    static EscLineAddress of(NodeId node); // also 0 if it is no place on a serial line
};

// "esc:12" and "12"; empty for anything else.
std::optional<EscLineAddress> addressTyped(QStringView text);

constexpr Place placeOnLine(EscLineAddress address)
{
    return {firstLine, address.node()};
}

} // namespace codewheel
