// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"
#include "vocabulary/number_code.h"
#include "vocabulary/position_coding.h"

namespace codewheel::k3 {

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
