// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/menu_list.h"

#include "widgets/look/label_text.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace codewheel {
namespace {

void listMenu(std::vector<ListedMenu> &menus, const QMenu &menu, const QString &path)
{
    const std::size_t own = menus.size();
    menus.push_back({path, {}});
    for (QAction *action : menu.actions()) {
        if (const QMenu *within = action->menu())
            listMenu(menus, *within, QStringLiteral("%1 > %2").arg(path, plainLabel(action->text())));
        else if (!action->isSeparator())
            menus[own].actions.push_back(action);
    }
}

} // namespace

std::vector<ListedMenu> menusOf(const QMainWindow &window)
{
    std::vector<ListedMenu> menus;
    for (const QAction *menu : window.menuBar()->actions())
        listMenu(menus, *menu->menu(), plainLabel(menu->text()));
    return menus;
}

} // namespace codewheel
