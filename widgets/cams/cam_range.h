// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/shown_encoder.h"

namespace codewheel {

struct ProjectDevice;

// The largest position the encoder has: by what is known of it; of one that is only planned by what is
// wanted, and what the project knows it had. Nothing where that does not tell it.
std::optional<std::int64_t> largestPosition(const ShownEncoder &encoder, const ProjectDevice &planned);

} // namespace codewheel
