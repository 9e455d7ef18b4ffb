// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "vocabulary/parameter.h"

namespace codewheel {

class EncoderSession;
class EscLineAccess;

// What is done before values are written to an encoder on a serial line.

// Reads what is about to be written.
Checked<void> readWhatIsWritten(const Call &call, EncoderSession &encoder, const ParameterValues &wanted);
// Whether nobody answers at the address the encoder is to be given, in either reading of its digits: whoever
// is there would answer along with it.
Checked<void> checkAddressIsFree(const Call &call, EscLineAccess &line, const EncoderSession &encoder,
                                 const ParameterValues &wanted);

} // namespace codewheel
