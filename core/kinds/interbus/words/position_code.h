// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

namespace codewheel::k3 {

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

// D24..D0 as 25-bit two's complement (Baumer manual 5, "Coding").
constexpr std::int64_t signedData(Word word) noexcept
{
    return signedNumber(data(word), dataBits);
}

// The position in steps that is in D24..D0.
constexpr std::int64_t decodePosition(Word word, PositionCoding coding) noexcept
{
    switch (coding) {
    case PositionCoding::signedBinary:
        return signedData(word);
    case PositionCoding::gray:
        return binaryFromGray(data(word));
    case PositionCoding::binary:
        break;
    }
    return data(word);
}

} // namespace codewheel::k3
