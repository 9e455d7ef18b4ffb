// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// Recordings, played and compared.
std::vector<Picture> recordingPictures();

} // namespace codewheel
