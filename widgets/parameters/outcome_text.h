// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

namespace codewheel {

// What a job of the parameter panel has done, where it went well: short, since the table shows the values and
// the messages keep them.
QString outcomeText(const EncoderSession &encoder, const Outcome &outcome);

} // namespace codewheel
