// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/asked_bus_actions.h"

#include "app/window/buses/bus_keys.h"
#include "app/window/look/described_action.h"
#include "app/window/window_actions.h"

#include <QMenu>

namespace codewheel {

AskedBusActions::AskedBusActions(WindowActions &window, const QString &title)
    : QObject(&window)
    , menu(new QMenu(title, window.menuParent()))
{
    menu->setIcon(lineIcon(Icon::ring));
    menu->setToolTipsVisible(true);
}

QAction *AskedBusActions::add(Icon icon, const QString &text, const QKeySequence &key, const QString &what)
{
    return described(menu->addAction(lineIcon(icon), text), key, what);
}

void AskedBusActions::addAfresh()
{
    afresh =
        foundBy(add(Icon::refresh, tr("Start a&fresh"), {}, {}), tr("reset, factory settings, no faults"));
}

void AskedBusActions::tellBus(const QString &bus)
{
    for (QAction *action : menu->actions())
        if (!action->isSeparator())
            codewheel::tellBus(action, bus);
}

void AskedBusActions::tellWhyNotDisconnected(const QString &why)
{
    described(disconnectBus, disconnectBus->shortcut(), why);
}

void AskedBusActions::setHasKeys(bool has)
{
    const auto keys = [has](const QAction &action, QList<QKeySequence> others) {
        return has ? QList{action.shortcut()} + others : QList{action.shortcut()};
    };
    settings->setShortcuts(keys(*settings, {bus_keys::connection, bus_keys::connectBus}));
    disconnectBus->setShortcuts(keys(*disconnectBus, {bus_keys::disconnectBus}));
}

} // namespace codewheel
