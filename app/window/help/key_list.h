// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"

#include <vector>

class QMainWindow;

namespace codewheel {

// All keys of the window, as its actions have them now: menu by menu, view by view, then what views answer
// without actions.
std::vector<KeyGroup> keysOf(const QMainWindow &window);

} // namespace codewheel
