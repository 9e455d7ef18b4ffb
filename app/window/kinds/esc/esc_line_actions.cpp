// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_actions.h"

#include "app/window/look/described_action.h"
#include "app/window/window_actions.h"
#include "widgets/look/describe.h"

#include <QMenu>

namespace codewheel {

EscLineActions::EscLineActions(WindowActions &window)
    : AskedBusActions(window, tr("Serial &line"))
{
    settings = add(Icon::parameters, tr("&Connection…"), Qt::SHIFT | Qt::Key_F6,
                   tr("How the line is connected: port and settings. Nothing is written"));
    search = add(Icon::search, tr("&Search for encoders…"), Qt::SHIFT | Qt::Key_F7,
                 tr("Asks one address after the other; nothing is written"));
    terminal = add(Icon::trace, tr("&Terminal"), Qt::SHIFT | Qt::Key_F8,
                   tr("Shows the traffic on the line, and sends what you type"));
    figures = add(Icon::information, tr("Line st&atistics"), Qt::CTRL | Qt::Key_F6,
                  tr("Port, state, answers and time-outs of the line"));
    foundBy(settings, tr("serial port, adapter, baud rate"));
    settings->setObjectName(QStringLiteral("lineSettings"));
    search->setObjectName(QStringLiteral("lineSearch"));
    terminal->setObjectName(QStringLiteral("lineTerminal"));
    menu->addSeparator();
    training =
        add(Icon::training, tr("T&raining line"), {}, tr("Three simulated encoders, in place of a port"));
    addAfresh();
    disconnectBus = add(Icon::cancel, tr("&Disconnect the line"), Qt::CTRL | Qt::SHIFT | Qt::Key_F6,
                        tr("Closes the serial line"));
    swapWarningBytes = checkable(new QAction(tr("&Swap warning bytes")));
    remove = new QAction(lineIcon(Icon::remove), tr("Remove from the serial &line"));
    window.insert(WindowActions::Section::kinds, {menu->menuAction()});
    window.insert(WindowActions::Section::device, {swapWarningBytes, remove});
    window.insert(WindowActions::Section::toolBar, {terminal});
    showChosen({});
}

void EscLineActions::showChosen(Chosen chosen)
{
    const QString others = tr("For encoders on the serial line");
    const bool canBeRemoved = chosen.isOnLine && chosen.isConnected;
    described(swapWarningBytes, Qt::CTRL | Qt::SHIFT | Qt::Key_F8,
              chosen.isOnLine ? tr("For an encoder that sends the low byte of its warnings first; nothing is "
                                   "sent")
                              : others);
    swapWarningBytes->setEnabled(chosen.isOnLine);
    swapWarningBytes->setChecked(chosen.isSwapped);
    described(remove, Qt::CTRL | Qt::SHIFT | Qt::Key_F7,
              canBeRemoved ? tr("The encoder is not asked any more; what it has stays as it is") : others);
    remove->setEnabled(canBeRemoved);
}

} // namespace codewheel
