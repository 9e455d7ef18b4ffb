// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"

namespace codewheel::profile {

// The serial protocol of Kübler, which has no words and no ID code.
inline constexpr Profile esc{"ESC"};

} // namespace codewheel::profile
