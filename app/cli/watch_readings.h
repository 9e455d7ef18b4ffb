// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/subcommand.h"
#include "encoder/instant.h"

namespace codewheel {

class EncoderSession;

// Watches what an encoder shows: looks every `interval` for so long, and prints a row when it shows something
// else than at the look before. Only reads. Ctrl+C ends it.
Answer watchReadings(const Call &call, const EncoderSession &encoder, Instant duration, Instant interval);

} // namespace codewheel
