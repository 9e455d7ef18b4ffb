// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <span>

namespace codewheel::canopen {

using Octets = std::span<const std::uint8_t>;

// As all numbers of CANopen: the lowest octet first. At most four of them.
inline std::uint32_t numberOf(Octets octets)
{
    std::uint32_t number = 0;
    for (auto octet = octets.rbegin(); octet != octets.rend(); ++octet)
        number = number << 8 | *octet;
    return number;
}

// "1388h"
inline QString hexNumber(std::uint32_t number, int digits = 0)
{
    return QStringLiteral("%1").arg(number, digits, 16, QLatin1Char('0')).toUpper() + u'h';
}

} // namespace codewheel::canopen
