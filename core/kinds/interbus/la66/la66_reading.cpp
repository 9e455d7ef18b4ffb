// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_reading.h"

#include "kinds/interbus/words/la66_word.h"

namespace codewheel {
namespace {

EncoderState stateOf(Word in) noexcept
{
    if (la66::isServiceMode(in))
        return EncoderState::service;
    if ((in & ~(la66::errorBit | la66::dataMask)) != 0)
        return EncoderState::unknown;
    return la66::hasError(in) ? EncoderState::error : EncoderState::operation;
}

} // namespace

Reading decodeLa66(Word in, Instant at) noexcept
{
    static_assert(la66::magnetOutside == 1 << magnetErrorNumber);
    Reading reading;
    reading.at = at;
    reading.in = in;
    reading.state = stateOf(in);
    reading.coding = PositionCoding::binary;
    if (reading.state == EncoderState::operation || reading.state == EncoderState::error)
        reading.position = la66::data(in);
    if (reading.state == EncoderState::error)
        reading.errorNumber = magnetErrorNumber;
    return reading;
}

} // namespace codewheel
