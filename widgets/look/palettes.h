// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

#include <QPalette>

namespace codewheel {

// Our light and our dark palette, complete for the Fusion style.
QPalette paletteOf(Shade shade);

} // namespace codewheel
