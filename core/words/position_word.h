// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_explain.h"

namespace codewheel {

// The IN word of an encoder that only tells its position: right justified, the bits above it 0. K1 has 16
// bits, K2 and K4 have 32 (FRABA manual 2.1.1, 2.1.2; TWK, table VI).
struct PositionWord
{
    int positionBits = 32; // 1..32, the low ones; the most of its profile where the resolution is not known
    PositionCoding coding = PositionCoding::binary;
    // K4: four bits are said to be control and status bits, and no source tells which. Nor what OUT means.
    bool hasStatusBits = false;
    bool hasOut = false;
};

namespace position_word {

// The bits above the position that are 1 although they should not be.
constexpr Word unusedBits(Word in, const PositionWord &format) noexcept
{
    return format.positionBits < 32 ? in >> format.positionBits << format.positionBits : 0;
}

// Steps. Nothing where bits above the position are 1: the encoder is not the one described. Negative numbers
// are the two's complement of the bits that the position has (assumed).
std::optional<std::int64_t> position(Word in, const PositionWord &format) noexcept;

// Total: each of the 2^32 words, in both directions, has one meaning.
Meaning explain(Word word, WordDirection direction, const PositionWord &format) noexcept;

} // namespace position_word
} // namespace codewheel
