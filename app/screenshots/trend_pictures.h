// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// The pictures of the trend.
std::vector<Picture> trendPictures();

} // namespace codewheel
