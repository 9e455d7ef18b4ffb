// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/event.h"

namespace codewheel {

// "Determine from device": the format of the scaling factor of a serial encoder (esc_scaling.h), from its
// own values. First the job that reads them ...
ReadParameters fractionBitsJob();
// ... then what follows from its outcome: the number of fraction bits. Refused as the job was, or with
// escFactorFitsNothing if no format fits, or more than one.
Result<int> fractionBitsOf(const Outcome &outcome);

} // namespace codewheel
