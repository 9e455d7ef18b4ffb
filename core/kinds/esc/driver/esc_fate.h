// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

namespace codewheel {

// Whether a job on a serial line that got this far has sent this value; without a parameter, the position.
bool wasSentOnEsc(const Progress &job, std::optional<Parameter> parameter);
// Whether nobody knows if the encoder has a value that this job sent but did not report as written: the job
// ended before that was checked.
bool isFateUnknownOnEsc(const EncoderSession &encoder, std::optional<Parameter> parameter,
                        const Outcome &outcome, const Progress &job);

} // namespace codewheel
