// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"

#include <vector>

class QMainWindow;

namespace codewheel {

// Keys that belong together: those of a menu, or those that work in one view.
struct KeyGroup
{
    QString title;
    QList<KeyHelp> rows;
};

// All keys of the window, as its actions have them now: menu by menu, view by view, then those that views
// handle without actions.
std::vector<KeyGroup> keysOf(const QMainWindow &window);

} // namespace codewheel
