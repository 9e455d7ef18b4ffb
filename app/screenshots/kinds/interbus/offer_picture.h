// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

#include <vector>

namespace codewheel {

// A ring that is offered to others, with clients: as it is shown, without a socket.
std::vector<Picture> offerPictures();

} // namespace codewheel
