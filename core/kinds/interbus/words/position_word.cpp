// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/position_word.h"

#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/position_code.h"

namespace codewheel::position_word {
namespace {

std::int64_t decoded(Word in, const PositionWord &format) noexcept
{
    switch (format.coding) {
    case PositionCoding::gray:
        return binaryFromGray(in);
    case PositionCoding::signedBinary:
        return signedNumber(in, format.positionBits);
    case PositionCoding::binary:
        break;
    }
    return in;
}

Meaning explainIn(Word in, const PositionWord &format) noexcept
{
    const auto steps = position(in, format);
    if (!steps)
        return {MeaningId::unusedBitsSet, {unusedBits(in, format), format.positionBits}};
    if (format.hasStatusBits)
        return {MeaningId::undescribedPosition, {*steps}};
    switch (format.coding) {
    case PositionCoding::gray:
        return {MeaningId::grayPosition, {*steps, in}};
    case PositionCoding::signedBinary:
        return {MeaningId::signedPosition, {*steps}};
    case PositionCoding::binary:
        break;
    }
    return {MeaningId::position, {*steps}};
}

} // namespace

std::optional<std::int64_t> position(Word in, const PositionWord &format) noexcept
{
    return unusedBits(in, format) == 0 ? std::optional(decoded(in, format)) : std::nullopt;
}

Meaning explain(Word word, WordDirection direction, const PositionWord &format) noexcept
{
    if (direction == WordDirection::in)
        return explainIn(word, format);
    return {format.hasOut ? MeaningId::undescribedOut : MeaningId::noOutWord, {word}};
}

} // namespace codewheel::position_word
