// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace codewheel {

// Puts the panels of the main window where they are at first in a window of this height.
void arrangePanels(QMainWindow &window);

// Brings those to the front that are looked at first.
void raiseFirstPanels(QMainWindow &window);

} // namespace codewheel
