// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <compare>
#include <cstdint>
#include <optional>

namespace codewheel {

// The address of a device on a serial line with the Kübler ESC protocol: 1..31, and 0 for the master address,
// which any device answers (manual, "Masteraddress: 00"). On the wire it is two hexadecimal digits.
struct LineAddress
{
    std::uint8_t value = 0;

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const LineAddress &, const LineAddress &) = default;

    static constexpr std::uint8_t last = 31;
    static constexpr LineAddress master() { return {0}; }
    bool isMaster() const { return value == 0; }
    bool isDevice() const { return value >= 1 && value <= last; }

    // The two digits on the wire: "12".
    QString onWire() const;
    // Both readings, as the window shows it: "12h (18)".
    QString shown() const;
    // One or two hexadecimal digits, 0..1Fh; nothing for anything else.
    static std::optional<LineAddress> fromWire(QStringView digits);
};

} // namespace codewheel
