// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

// Likewise into all of them.
inline void putNumber(std::span<std::uint8_t> octets, std::uint64_t number)
{
    for (std::uint8_t &octet : octets) {
        octet = static_cast<std::uint8_t>(number);
        number >>= 8;
    }
}

} // namespace codewheel::canopen
