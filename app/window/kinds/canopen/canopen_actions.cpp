// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_actions.h"

#include "app/window/look/described_action.h"
#include "app/window/window_actions.h"

#include <QMenu>

namespace codewheel {

CanopenActions::CanopenActions(WindowActions &window)
    : AskedBusActions(window, tr("CA&N bus"))
{
    settings = foundBy(add(Icon::parameters, tr("&Connection…"), Qt::CTRL | Qt::Key_F8,
                           tr("How the CAN bus is connected: interface or adapter, and rate. Nothing is "
                              "sent")),
                       tr("CANopen, SocketCAN, SLCAN, interface, adapter, bit rate"));
    settings->setObjectName(QStringLiteral("canSettings"));
    search = foundBy(add(Icon::search, tr("&Search for nodes…"), Qt::CTRL | Qt::Key_F10,
                         tr("Asks all numbers who is there, after a question; nothing is written")),
                     tr("scan, node number"));
    nodes = foundBy(add(Icon::information, tr("&Nodes and figures"), Qt::CTRL | Qt::SHIFT | Qt::Key_F9,
                        tr("Nodes with state, heartbeat and errors; load and counters of the bus")),
                    tr("NMT, start, stop, reset, EMCY, heartbeat, load"));
    unnumbered = foundBy(add(Icon::search, tr("Devices &without a number…"), {},
                             tr("Finds a device without a node number by LSS, to give it one; nothing is "
                                "written before a question")),
                         tr("LSS, fast scan, node number"));
    unnumbered->setObjectName(QStringLiteral("canUnnumbered"));
    search->setObjectName(QStringLiteral("canSearch"));
    nodes->setObjectName(QStringLiteral("canNodes"));
    menu->addSeparator();
    training = foundBy(add(Icon::training, tr("CAN t&raining bus"), {},
                           tr("Three simulated encoders on CANopen, and one without a node number, in place "
                              "of an adapter")),
                       tr("CANopen, simulated"));
    training->setObjectName(QStringLiteral("canTraining"));
    addAfresh();
    disconnectBus = add(Icon::cancel, tr("&Disconnect the CAN bus"), Qt::CTRL | Qt::SHIFT | Qt::Key_F10,
                        tr("Leaves the CAN bus"));
    setup = foundBy(new QAction(lineIcon(Icon::parameters), tr("N&umber and rate…")),
                    tr("LSS, node number, bit rate, baud rate, address, 2000h"));
    setup->setObjectName(QStringLiteral("canSetup"));
    remove = new QAction(lineIcon(Icon::remove), tr("Remove from the CAN b&us"));
    window.insert(WindowActions::Section::kinds, {menu->menuAction()});
    window.insert(WindowActions::Section::device, {setup, remove});
    showChosen(false);
}

void CanopenActions::showChosen(bool isConnected)
{
    described(setup, Qt::CTRL | Qt::SHIFT | Qt::Key_F12,
              isConnected ? tr("Gives the encoder another node number or rate; nothing is written before a "
                               "question")
                          : tr("For encoders on the CAN bus"));
    setup->setEnabled(isConnected);
    described(remove, {},
              isConnected ? tr("The encoder is not asked any more; what it has stays as it is")
                          : tr("For encoders on the CAN bus"));
    remove->setEnabled(isConnected);
}

} // namespace codewheel
