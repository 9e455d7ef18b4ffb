// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// The pictures of the CAN bus: its nodes, traffic and objects, its pages, and why there is no data.
std::vector<Picture> canopenPictures();

} // namespace codewheel
