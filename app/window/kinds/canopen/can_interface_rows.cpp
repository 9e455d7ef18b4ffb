// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/can_interface_rows.h"

#include "app/window/connect/trouble_of.h"
#include "can/can_refusals.h"
#include "can/can_state.h"
#include "kinds/canopen/finder/can_interface_finder.h"
#include "links/can_link_to.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanInterfaceText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanInterfaceRows)
};

QString stateOf(const CanInterface &interface)
{
    if (!interface.isUp)
        return CanInterfaceText::tr("switched off");
    QStringList parts{CanInterfaceText::tr("on")};
    const CanStatus &status = interface.status;
    if (status.rate)
        parts << sentence(CanInterfaceText::tr("%1 kBit/s"), {inKilobits(*status.rate)});
    if (interface.isVirtual)
        parts << CanInterfaceText::tr("virtual: no adapter is behind it");
    if (status.state != CanState::notKnown)
        parts << canStateText(status.state);
    if (status.listensOnly == true)
        parts << CanInterfaceText::tr("listens only");
    return parts.join(QStringLiteral(", "));
}

// The worst first.
Trouble troubleWith(const CanInterface &interface, int rate)
{
    if (!interface.isUp)
        return troubleOf(Refusal{RefusalKind::link,
                                 CanRefusalId::interfaceDown,
                                 {interface.name, switchOnCommand(interface, rate)}});
    if (interface.status.state == CanState::busOff)
        return {sentence(CanInterfaceText::tr("%1 has left the bus after too many errors (bus off): the rate "
                                              "or the wiring is wrong, or nobody else is there. Check these, "
                                              "then start it again."),
                         {interface.name}),
                restartCommand(interface.name)};
    if (!interface.isVirtual && interface.status.listensOnly == false)
        return {
            sentence(CanInterfaceText::tr("%1 acknowledges what others send, in Watch too. If it is to do "
                                          "nothing but listen, set it so; for Operate, set it back."),
                     {interface.name}),
            listenOnlyCommand(interface, rate)};
    return {};
}

} // namespace

CanInterfaceRows canInterfaceRows(const std::vector<CanInterface> &interfaces)
{
    CanInterfaceRows listed{
        .rows = {},
        .none = {CanInterfaceText::tr("This computer has no CAN interface. Plug its adapter in and refresh "
                                      "the list; one that is a serial port is another link, above."),
                 QStringLiteral("ip link")}};
    for (const CanInterface &interface : interfaces)
        listed.rows.push_back({interface.name, stateOf(interface),
                               [interface](int rate) { return troubleWith(interface, rate); }});
    return listed;
}

PortRows canInterfacesToHear(const std::vector<CanInterface> &interfaces)
{
    PortRows listed;
    for (const CanInterface &interface : interfaces) {
        listed.rows.push_back(
            {interface.name, sentence(CanInterfaceText::tr("CAN interface, %1"), {stateOf(interface)}), {}});
        if (listed.trouble.sentence.isEmpty())
            listed.trouble = troubleWith(interface, proposedCanRate);
    }
    return listed;
}

PortRows canInterfacesToHear()
{
    return canInterfacesToHear(canInterfaces());
}

std::unique_ptr<PlaceFinder> canInterfaceFinder(const QString &interface)
{
    if (!canInterface(interface, Computer(), {}))
        return nullptr;
    return std::make_unique<CanInterfaceFinder>(canLinkTo({.where = interface}));
}

QStringList canAdapterRows()
{
    QStringList rows;
    for (const CanInterface &interface : canInterfaces())
        rows << QStringLiteral("%1: CAN, %2, %3 Bd, %4")
                    .arg(interface.name, interface.isUp ? QStringLiteral("up") : QStringLiteral("down"))
                    .arg(interface.status.rate.value_or(0))
                    .arg(canStateKey(interface.status.state));
    return rows;
}

} // namespace codewheel
