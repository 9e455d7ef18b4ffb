// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

class QAction;
class QMainWindow;

namespace codewheel {

// A menu of the window, or one within it.
struct ListedMenu
{
    QString path;                   // "View > Panels"
    std::vector<QAction *> actions; // its own, without separators and menus
};

// All menus of the menu bar, each before those within it.
std::vector<ListedMenu> menusOf(const QMainWindow &window);

} // namespace codewheel
