// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

namespace codewheel {

constexpr Word grayFromBinary(Word binary) noexcept
{
    return binary ^ (binary >> 1);
}

constexpr Word binaryFromGray(Word gray) noexcept
{
    for (unsigned shift = 1; shift < 32; shift *= 2)
        gray ^= gray >> shift;
    return gray;
}

// Two's complement with the given number of bits.
constexpr std::int64_t signedNumber(Word number, int bits) noexcept
{
    const std::int64_t range = std::int64_t{1} << bits;
    return number < range / 2 ? std::int64_t{number} : number - range;
}

} // namespace codewheel
