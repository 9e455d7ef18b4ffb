// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "encoder/parameter.h"

namespace codewheel {

class EncoderSession;

// What `write` does besides for an encoder on a serial line, and `transfer` before it shows its plan.

// Reads what is about to be written. Reading a serial encoder disturbs nothing, so that the plan can show
// what it has, and the commands in full.
Checked<void> readBefore(const Call &call, EncoderSession &encoder, const ParameterValues &wanted);

// Whether nobody answers at the address that the encoder is to be given, in either reading of its digits:
// whoever is there would answer with it.
Checked<void> checkAddressIsFree(const Call &call, const EncoderSession &encoder,
                                 const ParameterValues &wanted);

// What has to be typed from now on to reach an encoder that was given another address or baud rate.
QString whereItIsNow(const Call &call, const EncoderSession &encoder, const ParameterValues &wanted);

} // namespace codewheel
