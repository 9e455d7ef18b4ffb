// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_actions.h"

#include "app/window/buses/bus_keys.h"
#include "app/window/look/described_action.h"
#include "app/window/window_actions.h"
#include "widgets/look/icons.h"

#include <QMenu>

namespace codewheel {

RingActions::RingActions(WindowActions &window)
    : QObject(&window)
{
    const auto action = [](Icon icon, const QString &text) { return new QAction(lineIcon(icon), text); };
    connection = described(action(Icon::parameters, tr("Connec&tion…")), bus_keys::connection,
                           tr("How this ring is reached: training bus, or a gateway; with a test"));
    foundBy(connection, tr("Modbus, TCP, RTU, gateway"));
    registers = action(Icon::list, tr("Re&gisters…"));
    foundBy(registers, tr("word order, byte order, gateway"));
    connectBus = described(action(Icon::ring, tr("&Connect")), bus_keys::connectBus,
                           tr("Connects to the ring; nothing is sent"));
    disconnectBus = described(action(Icon::cancel, tr("&Disconnect")), bus_keys::disconnectBus,
                              tr("Leaves the ring: work goes on offline"));
    readIn = described(
        action(Icon::read, tr("&Read in the ring")), Qt::CTRL | Qt::SHIFT | Qt::Key_R,
        tr("The master finds the devices of the ring again; data cycles stop meanwhile. Needs Operate."));
    confirmDiagnostics =
        described(action(Icon::ok, tr("&Confirm diagnostics")), Qt::CTRL | Qt::Key_F9,
                  tr("Confirms peripheral faults; one whose cause is still there comes back. Needs "
                     "Operate."));
    switchSegment = action(Icon::power, tr("Switch se&gment off or on"));
    offer = action(Icon::training, tr("&Offer to others…"));
    endOffer = described(action(Icon::stop, tr("&Stop offering")), {},
                         tr("The ring is no longer offered to others: all clients are disconnected"));
    afresh =
        foundBy(described(action(Icon::refresh, tr("Start a&fresh")), Qt::ALT | Qt::SHIFT | Qt::Key_A, {}),
                tr("reset, factory settings, no faults"));
    showSegment(false, false);
    showRegisters(false);
    showOffer({}, false);
    window.insert(WindowActions::Section::connections,
                  {connection, registers, connectBus, disconnectBus, readIn});
    makeTrainingMenu(window);
    window.insert(WindowActions::Section::services, {confirmDiagnostics, switchSegment});
}

void RingActions::makeTrainingMenu(WindowActions &window)
{
    auto *menu = new QMenu(tr("Tr&aining"), window.menuParent());
    menu->setToolTipsVisible(true);
    menu->addActions({offer, endOffer, afresh});
    offer->setParent(menu);
    endOffer->setParent(menu);
    afresh->setParent(menu);
    window.insert(WindowActions::Section::connections, {menu->menuAction()});
}

void RingActions::disable()
{
    for (QAction *action : {connection, registers, connectBus, disconnectBus, readIn, confirmDiagnostics,
                            offer, endOffer, afresh})
        action->setEnabled(false);
    showSegment(false, false);
}

void RingActions::tellBus(const QString &bus)
{
    for (QAction *action : {connection, registers, connectBus, disconnectBus, readIn, confirmDiagnostics,
                            offer, endOffer, afresh})
        codewheel::tellBus(action, bus);
}

void RingActions::tellWhyNotDisconnected(const QString &why)
{
    described(disconnectBus, disconnectBus->shortcut(), why);
}

void RingActions::setHasKeys(bool has)
{
    const auto give = [has](QAction *action, QKeyCombination key) {
        described(action, has ? QKeySequence(key) : QKeySequence(), action->statusTip());
    };
    give(connection, bus_keys::connection);
    give(connectBus, bus_keys::connectBus);
    give(disconnectBus, bus_keys::disconnectBus);
}

void RingActions::showSegment(bool hasMaster, bool isChosen)
{
    described(switchSegment, Qt::SHIFT | Qt::Key_F9,
              !hasMaster  ? tr("The ring is not connected.")
              : !isChosen ? tr("No device with a segment of this ring is chosen.")
                          : tr("Takes the segment of the chosen device, and what is behind it, out of the "
                               "data cycles, after asking, or puts it back. Needs Operate."));
    switchSegment->setEnabled(hasMaster && isChosen);
}

void RingActions::showRegisters(bool isGateway)
{
    described(registers, Qt::ALT | Qt::SHIFT | Qt::Key_R,
              isGateway ? tr("The registers of each device, its word in four readings, and the word order")
                        : tr("Only a ring behind a gateway has registers."));
    registers->setEnabled(isGateway);
}

void RingActions::showOffer(const QString &whyNot, bool isOffered)
{
    described(offer, Qt::ALT | Qt::SHIFT | Qt::Key_O,
              !whyNot.isEmpty()
                  ? whyNot
                  : tr("Any Modbus client can work on this simulated ring; who does is shown there"));
    offer->setEnabled(whyNot.isEmpty() || isOffered);
    endOffer->setEnabled(isOffered);
}

} // namespace codewheel
