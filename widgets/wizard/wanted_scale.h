// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/position_scale.h"
#include "widgets/wizard/setup.h"

namespace codewheel {

// The scale the encoder has now, and the one it will have after the handshake; nothing if something is not
// known.
std::optional<PositionScale> scaleNow(const Setup &setup);
std::optional<PositionScale> scaleAfter(const Setup &setup);

// A value after the handshake, counting what the encoder sets along with those written.
std::optional<std::int64_t> valueThenOf(const Setup &setup, Parameter parameter);

// What the shaft will read where it stands: the preset if it is initialised, otherwise calculated from what
// the encoder shows now.
std::optional<ForetoldPosition> positionAfterHandshake(const Setup &setup);

// The same for an encoder that runs with what it has taken so far; before the first word, from the position
// shown then.
std::optional<ForetoldPosition> positionWithTaken(const Setup &setup);

} // namespace codewheel
