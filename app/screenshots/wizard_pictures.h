// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/screenshots/picture.h"

namespace codewheel {

// The wizard's pages with the example of FRABA's manual, and with a linear encoder.
std::vector<Picture> wizardPictures();

} // namespace codewheel
