// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

namespace codewheel {

struct WriteWish
{
    ParameterValues wanted;
    bool initialisePreset = false; // set the position to the preset now
    bool writeAll = false;         // also what the encoder already has
};

// The job for a wish: what is known and equal is left out, in the order of the description. Where the encoder
// can be read and a value is not known from reading, the job reads it first and leaves it out if it is there
// already. A used-up preset (FRABA) is programmed again, or it could not be initialised.
WriteParameters jobForWish(const EncoderSession &encoder, const WriteWish &wish);

// All that is known of an encoder.
std::vector<Known> allKnown(const EncoderSession &encoder);

// EEPROM writes these steps will cost, at most: one per parameter, and the preset where it is stored.
int eepromWritesOf(const std::vector<Step> &steps, const Capabilities &can);

} // namespace codewheel
