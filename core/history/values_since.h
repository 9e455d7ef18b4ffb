// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/parameter.h"

namespace codewheel {

// What was known of an encoder since a moment.
struct ValuesSince
{
    Instant from{};
    ParameterValues values{};
};

} // namespace codewheel
