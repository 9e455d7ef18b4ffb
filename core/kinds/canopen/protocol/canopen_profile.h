// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"

namespace codewheel::profile {

// Encoders on CANopen, with the object dictionary of CiA 301 and CiA 406.
inline constexpr Profile cia406{"CiA-406"};

} // namespace codewheel::profile
