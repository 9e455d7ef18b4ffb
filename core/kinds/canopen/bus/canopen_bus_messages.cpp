// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_messages.h"

#include "can/can_state.h"
#include "kinds/canopen/bus/other_master.h"
#include "kinds/canopen/protocol/nmt.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/port_text.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

constexpr auto canopenBusMessageRows = std::to_array<SentenceRow>({
    {CanopenBusMessageId::opened, "canopenOpened",
     QT_TRANSLATE_NOOP("Message", "The CAN bus (%1) is open at %2 kBit/s.")},
    {CanopenBusMessageId::closed, "canopenClosed",
     QT_TRANSLATE_NOOP("Message", "The CAN bus (%1) was closed.")},
    {CanopenBusMessageId::back, "canopenBack",
     QT_TRANSLATE_NOOP("Message", "The CAN bus (%1) is open again, and only watched.")},
    {CanopenBusMessageId::otherMasterHeard, "canopenOtherMasterHeard",
     QT_TRANSLATE_NOOP("Message", "Another master is at work on this bus. Heard: %1.")},
    {CanopenBusMessageId::nodeDoubled, "canopenNodeDoubled",
     QT_TRANSLATE_NOOP("Message", "Two devices have this node number: more answers or heartbeats come than "
                                  "one sends. Give one of them another number.")},
    {CanopenBusMessageId::heartbeatLost, "canopenHeartbeatLost",
     QT_TRANSLATE_NOOP("Message", "The heartbeat of this node does not come any more.")},
    {CanopenBusMessageId::heartbeatBack, "canopenHeartbeatBack",
     QT_TRANSLATE_NOOP("Message", "The heartbeat of this node comes again.")},
    {CanopenBusMessageId::loadHigh, "canopenLoadHigh",
     QT_TRANSLATE_NOOP("Message",
                       "The bus is %1 % full: frames of low priority may come late or not at all.")},
    {CanopenBusMessageId::nodesFound, "canopenNodesFound",
     QT_TRANSLATE_NOOP("Message", "Nodes found on the CAN bus: %1.")},
    {CanopenBusMessageId::nodesStopped, "canopenNodesStopped",
     QT_TRANSLATE_NOOP("Message", "ALARM STOP: the nodes that were started from here were stopped: %1.")},
    {CanopenBusMessageId::allNodesStopped, "canopenAllNodesStopped",
     QT_TRANSLATE_NOOP("Message", "ALARM STOP: all nodes were stopped.")},
    {CanopenBusMessageId::stopsNotSent, "canopenStopsNotSent",
     QT_TRANSLATE_NOOP("Message", "The command that stops the nodes could not be sent. It is sent once the "
                                  "bus is there again. Stop the machine by its own means.")},
    {CanopenBusMessageId::nodeNumbered, "canopenNodeNumbered",
     QT_TRANSLATE_NOOP("Message", "Node %1 has stored a new number: it is node %2 now.")},
    {CanopenBusMessageId::deviceNumbered, "canopenDeviceNumbered",
     QT_TRANSLATE_NOOP("Message", "A device without a number has stored one: it is node %1 now.")},
    {CanopenBusMessageId::nodeRateStored, "canopenNodeRateStored",
     QT_TRANSLATE_NOOP("Message", "Node %2 says that it has stored the rate %1 kBit/s, in force once its "
                                  "supply was off and on.")},
    {CanopenBusMessageId::objectWritten, "canopenObjectWritten",
     QT_TRANSLATE_NOOP("Message", "%1 was written: %2.")},
    {CanopenBusMessageId::objectInDoubt, "canopenObjectInDoubt",
     QT_TRANSLATE_NOOP("Message", "%1 was sent: %2. No answer came, so whether the node has taken "
                                  "it is not known.")},
    {CanopenBusMessageId::nmtSent, "canopenNmtSent", QT_TRANSLATE_NOOP("Message", "NMT was sent: %1.")},
    {CanopenBusMessageId::nmtInDoubt, "canopenNmtInDoubt",
     QT_TRANSLATE_NOOP("Message", "Whether NMT has gone out is not known: the adapter does not tell. It was "
                                  "%1.")},
});

static_assert(areInOrder(canopenBusMessageRows, &SentenceRow::id, CanopenBusMessageId::nmtInDoubt));

QString linkText(const RefusalArgument &link)
{
    const QString text = argumentText(link);
    return text == trainingPort ? QCoreApplication::translate("SimulatedCan", "simulated bus") : text;
}

QString nmtText(const Message &message)
{
    const auto number = [&](std::size_t i) {
        const auto *its =
            i < message.arguments.size() ? std::get_if<std::int64_t>(&message.arguments[i]) : nullptr;
        return its != nullptr ? static_cast<int>(*its) : 0;
    };
    return canopen::NmtRequest{static_cast<canopen::NmtCommand>(number(0)), number(1)}.text();
}

QString canopenBusMessageText(const Message &message)
{
    if (message.arguments.empty())
        return rowText(message);
    QStringList parts = argumentTexts(message.arguments);
    const CanopenBusMessageId id = *message.id.as<CanopenBusMessageId>();
    if (id <= CanopenBusMessageId::back)
        parts.front() = linkText(message.arguments.front());
    if (const auto *rate = std::get_if<std::int64_t>(&message.arguments.back());
        rate != nullptr && id == CanopenBusMessageId::opened)
        parts.back() = inKilobits(static_cast<int>(*rate));
    else if (id == CanopenBusMessageId::otherMasterHeard)
        parts.front() = OtherMaster::textOf(message.arguments.front());
    else if (id == CanopenBusMessageId::nmtSent || id == CanopenBusMessageId::nmtInDoubt)
        parts.front() = nmtText(message);
    return rowText(message, parts);
}

} // namespace

constinit const MessageFamily canopenBusMessages{canopenBusMessageRows, canopenBusMessageText};

} // namespace codewheel
