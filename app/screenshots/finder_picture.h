// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

#include <vector>

namespace codewheel {

// A search for encoders that has found some: as it is shown, without a port.
std::vector<Picture> finderPictures();

} // namespace codewheel
