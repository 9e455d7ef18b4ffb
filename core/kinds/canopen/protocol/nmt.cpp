// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/nmt.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::canopen {
namespace {

struct NmtTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenNmt)
};

QString toAll(const NmtRequest &request)
{
    switch (request.command) {
    case NmtCommand::start:
        return NmtTexts::tr("start all nodes");
    case NmtCommand::stop:
        return NmtTexts::tr("stop all nodes");
    case NmtCommand::preOperational:
        return NmtTexts::tr("all nodes to pre-operational");
    case NmtCommand::resetNode:
        return NmtTexts::tr("reset all nodes");
    case NmtCommand::resetCommunication:
        return NmtTexts::tr("reset the communication of all nodes");
    }
    return sentence(NmtTexts::tr("unknown command %1 to all nodes"),
                    {hexNumber(static_cast<std::uint8_t>(request.command), 2)});
}

QString toOne(const NmtRequest &request)
{
    const QString number = QString::number(request.node);
    const QString node =
        request.node > lastNode ? sentence(NmtTexts::tr("%1, which no node has"), {number}) : number;
    switch (request.command) {
    case NmtCommand::start:
        return sentence(NmtTexts::tr("start node %1"), {node});
    case NmtCommand::stop:
        return sentence(NmtTexts::tr("stop node %1"), {node});
    case NmtCommand::preOperational:
        return sentence(NmtTexts::tr("node %1 to pre-operational"), {node});
    case NmtCommand::resetNode:
        return sentence(NmtTexts::tr("reset node %1"), {node});
    case NmtCommand::resetCommunication:
        return sentence(NmtTexts::tr("reset the communication of node %1"), {node});
    }
    return sentence(NmtTexts::tr("unknown command %1 to node %2"),
                    {hexNumber(static_cast<std::uint8_t>(request.command), 2), node});
}

} // namespace

std::optional<NmtRequest> NmtRequest::read(Octets data)
{
    if (data.size() != 2)
        return std::nullopt;
    return NmtRequest{static_cast<NmtCommand>(data[0]), data[1]};
}

CanFrame NmtRequest::frame() const
{
    return frameOf(CobId{.service = CobId::Service::nmt}.identifier(),
                   std::array{static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(node)});
}

QString NmtRequest::text() const
{
    return node == 0 ? toAll(*this) : toOne(*this);
}

std::optional<NodeState> NodeState::read(Octets data)
{
    constexpr std::uint8_t toggleBit = 0x80;
    if (data.size() != 1)
        return std::nullopt;
    return NodeState{static_cast<NmtState>(data[0] & ~toggleBit), (data[0] & toggleBit) != 0};
}

QString NodeState::text() const
{
    switch (state) {
    case NmtState::bootUp:
        return NmtTexts::tr("boot-up");
    case NmtState::stopped:
        return NmtTexts::tr("stopped");
    case NmtState::operational:
        return NmtTexts::tr("operational");
    case NmtState::preOperational:
        return NmtTexts::tr("pre-operational");
    }
    return sentence(NmtTexts::tr("unknown state %1"), {hexNumber(static_cast<std::uint8_t>(state), 2)});
}

} // namespace codewheel::canopen
