// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_explain.h"

namespace codewheel {

// The IN word of an encoder that only reports its position: right-justified, the bits above it 0. K1 has 16
// bits, K2 and K4 have 32 (FRABA manual 2.1.1, 2.1.2; TWK, table VI).
struct PositionWord
{
    int positionBits = 32; // 1..32, the low ones; if the resolution is unknown, the profile's maximum
    PositionCoding coding = PositionCoding::binary;
    // K4: four bits are said to be control and status bits, but no source says which, nor what OUT means.
    bool hasStatusBits = false;
    bool hasOut = false;
};

namespace position_word {

// The bits above the position that are 1 but should not be.
constexpr Word unusedBits(Word in, const PositionWord &format) noexcept
{
    return format.positionBits < 32 ? in >> format.positionBits << format.positionBits : 0;
}

// Steps. Empty if bits above the position are 1: the encoder is not the one described. Negative numbers are
// in two's complement over the bits that the position has (assumed).
std::optional<std::int64_t> position(Word in, const PositionWord &format) noexcept;

// Total: each of the 2^32 words, in either direction, has one meaning.
Meaning explain(Word word, WordDirection direction, const PositionWord &format) noexcept;

} // namespace position_word
} // namespace codewheel
