// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// The pictures of the serial line: terminal, figures, settings and search, and its encoders in panels and
// wizard.
std::vector<Picture> linePictures();

} // namespace codewheel
