// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

namespace codewheel {

// Whether a job on a serial line that came this far has sent this value; without one, the position.
bool wasSentOnEsc(const Progress &job, std::optional<Parameter> parameter);
// Whether nobody knows if the encoder has a value that this job sent, and that it did not tell as written:
// the job ended before that was looked at.
bool isFateUnknownOnEsc(const EncoderSession &encoder, std::optional<Parameter> parameter,
                        const Outcome &outcome, const Progress &job);

} // namespace codewheel
