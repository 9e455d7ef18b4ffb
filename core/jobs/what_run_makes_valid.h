// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

class EncoderSession;

// Sentences about an encoder in parameterization: what its IN confirms, and what run makes valid, as far as
// is known.
QString whatRunMakesValid(const EncoderSession &encoder);
// What the encoder does by that then. `positionThen`: a sentence on which position it will then read, if that
// is known.
QString whatFollowsRun(const EncoderSession &encoder, const QString &positionThen = {});

} // namespace codewheel
