// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAction;
class QDockWidget;
class QMainWindow;

namespace codewheel {

// Puts the panels of the main window where they are at first in a window of this height.
void arrangePanels(QMainWindow &window);

// Brings those to the front that are looked at first.
void raiseFirstPanels(QMainWindow &window);

// Shows a panel and gives it the keys, also when it is behind another one; hides it when it is in sight.
// Belongs to the panel.
QAction *makePanelAction(QDockWidget &panel);

} // namespace codewheel
