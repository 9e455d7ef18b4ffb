// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/shown_encoder.h"

namespace codewheel {

struct ProjectDevice;

// The largest position of the encoder, from what is known of it; for one that is only planned, from the
// wanted values and from what the project remembers. Nothing where these do not tell.
std::optional<std::int64_t> largestPosition(const ShownEncoder &encoder, const ProjectDevice &planned);

} // namespace codewheel
