// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"

// The protocols of encoders with words: ENCOM profile 71 (FRABA manual 2.1), and the TR LA-66.
namespace codewheel::profile {

inline constexpr Profile k1{"K1"};
inline constexpr Profile k2{"K2"};
inline constexpr Profile k3{"K3"};
inline constexpr Profile k4{"K4"};
inline constexpr Profile la66{"LA-66"};
inline constexpr Profile ofRings[] = {k1, k2, k3, k4, la66};

} // namespace codewheel::profile
