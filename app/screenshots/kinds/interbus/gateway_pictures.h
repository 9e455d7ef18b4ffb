// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// The pictures of a ring behind a gateway: its connection with a test, its registers, its panel.
std::vector<Picture> gatewayPictures();

} // namespace codewheel
