// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"
#include "kinds/canopen/protocol/canopen_address.h"

#include <QStringList>

namespace codewheel {
namespace {

QString placeText(int node)
{
    return CanopenAddress{node}.place().toString();
}

} // namespace

void CanopenWork::carryOutNext(CanopenCommand &command)
{
    std::visit([this](auto &c) { carryOut(c); }, command);
}

void CanopenWork::carryOut(canopen_command::StartJob &c)
{
    AskingWork::carryOut(c);
    if (driver(c.device) != nullptr)
        driver(c.device)->mayStopNode(false); // it was agreed to for this one
}

void CanopenWork::carryOut(canopen_command::MayStopNode &c)
{
    if (driver(c.device) != nullptr)
        driver(c.device)->mayStopNode(true);
}

void CanopenWork::carryOut(canopen_command::AddNode &c)
{
    const int number = c.driver->node();
    nodeAt(number).device = drivers.size();
    if (const auto heard = nodeAt(number).watch.state()) { // before
        CanFrame told{.id = canopen::CobId{canopen::CobId::Service::errorControl, number}.identifier(),
                      .length = 1,
                      .time = link.now()};
        told.bytes[0] = static_cast<std::uint8_t>(*heard);
        c.driver->take(told, link.now());
    }
    drivers.push_back(std::move(c.driver));
    settle(number);
}

void CanopenWork::carryOut(canopen_command::RemoveDevice &c)
{
    if (driver(c.device) == nullptr)
        return;
    Node &node = nodeAt(driver(c.device)->node());
    AskingWork::carryOut(c);
    node.device.reset();
    if (node.request && std::holds_alternative<canopen::NmtRequest>(*node.request))
        node.request.reset();
    for (auto &[identifier, devices] : listeners)
        devices.erase(c.device);
}

bool CanopenWork::useOperate(bool on)
{
    if (!on) {
        dropTyped();
        endScan(true);
        leaveOff();
    }
    state.operate = on;
    useAsWanted();
    return state.connected;
}

void CanopenWork::carryOut(canopen_command::AlarmStop &c)
{
    AskingWork::carryOut(c);
    for (const auto &node : nodes)
        if (node && node->isTypedUnderWay) {
            node->client.cancel(link.now());
            ended(*node, {.kind = canopen::SdoOutcome::Kind::noAnswer});
        }
    canopen_command::CancelConfigure configuration;
    carryOut(configuration);
    if (waiting && waiting->by != Outgoing::By::alarmStop) { // refused, as nothing of it was sent
        underWay.push_front(*std::exchange(waiting, std::nullopt));
        fate(CanFate::refused);
    }
    for (const Outgoing &sent : underWay)
        if (const auto command = canopen::NmtRequest::read(sent.frame.data()); command && sent.frame.id == 0)
            noteCommand(*command, true);
    if (started.empty())
        return;
    const bool isAll = started.contains(0);
    QStringList numbers;
    for (const int node : started)
        numbers << QString::number(node);
    stops = isAll ? std::set{0} : started;
    state.stopsWait = true;
    tell({.severity = Severity::attention,
          .id = isAll ? CanopenBusMessageId::allNodesStopped : CanopenBusMessageId::nodesStopped,
          .arguments = isAll ? std::vector<RefusalArgument>()
                             : std::vector<RefusalArgument>{numbers.join(QStringLiteral(", "))}});
}

void CanopenWork::carryOut(canopen_command::SendBesideOthers & /*c*/)
{
    state.besideOthers = true;
    settleAll();
}

void CanopenWork::carryOut(canopen_command::TakeUnsureWatch & /*c*/)
{
    link.takeUnsureWatch();
    reopenAt = link.now();
}

void CanopenWork::carryOut(canopen_command::Send &c)
{
    const auto allowed = maySend(state, {});
    if (allowed)
        typed.push_back(c.frame);
    else
        tellEvent(FrameSent{c.frame, CanFate::refused, allowed.error()});
}

void CanopenWork::carryOut(canopen_command::Transfer &c)
{
    const int number = c.request.node;
    if (const auto allowed = maySend(state, placeText(number)); !allowed) {
        tellEvent(TransferEnded{.request = std::move(c.request), .refused = allowed.error()});
        return;
    }
    nodeAt(number).typed.push_back(std::move(c.request));
    settle(number);
}

void CanopenWork::carryOut(canopen_command::Configure &c)
{
    const auto allowed = maySend(state, {});
    if (allowed)
        configurations.push_back(c.request);
    else
        tellEvent(Configured{.request = c.request, .refused = allowed.error()});
}

void CanopenWork::carryOut(canopen_command::CancelConfigure & /*c*/)
{
    breakOffConfiguration();
    while (!configurations.empty())
        endConfiguration({.kind = canopen::LssOutcome::Kind::notSent});
}

void CanopenWork::carryOut(canopen_command::Scan & /*c*/)
{
    auto allowed = maySend(state, {});
    if (const auto busy = busyRefusal(); allowed && busy)
        allowed = tl::unexpected(*busy);
    if (!allowed) {
        tell({.severity = Severity::attention, .refusal = allowed.error()});
        tellEvent(NodesScanned{.isDone = true, .isCancelled = true});
        return;
    }
    scan.emplace(canopen::NodeScanTimes{.rate = rateNow()}, link.now());
    state.scanning = true;
    foundTold = 0;
}

void CanopenWork::jobStopped(std::size_t device)
{
    const int number = driver(device)->node();
    Node &node = nodeAt(number);
    if (!node.request)
        return;
    std::erase_if(commands, [&](const Outgoing &command) { return command.node == number; });
    const auto isItsOwn = [&](const Outgoing &its) {
        return its.node == number && (its.by == Outgoing::By::transfer || its.by == Outgoing::By::driver);
    };
    if (waiting && isItsOwn(*waiting))
        waiting.reset();
    node.client.cancel(link.now());
    node.client.takeOutcome();
    answerDriver(node, {.kind = canopen::SdoOutcome::Kind::notSent});
    settle(number);
}

void CanopenWork::dropTyped()
{
    for (const CanFrame &frame : std::exchange(typed, {}))
        tellEvent(FrameSent{frame});
    for (const auto &node : nodes)
        while (node && node->typed.size() > (node->isTypedUnderWay ? 1U : 0U)) {
            tellEvent(TransferEnded{node->typed.back()});
            node->typed.pop_back();
        }
    while (configurations.size() > (isConfiguring ? 1U : 0U)) {
        tellEvent(Configured{configurations.back()});
        configurations.pop_back();
    }
}

void CanopenWork::endScan(bool cancelled)
{
    if (!scan)
        return;
    const std::vector<canopen::FoundNode> found = scan->found();
    tellEvent(NodesScanned{scan->progress(), found, true, cancelled});
    tell({.id = CanopenBusMessageId::nodesFound, .arguments = {static_cast<std::int64_t>(found.size())}});
    scan.reset();
    state.scanning = false;
    settleAll();
    publish();
}

void CanopenWork::endConfiguration(const canopen::LssOutcome &outcome)
{
    tellEvent(Configured{configurations.front(), outcome, {}});
    configurations.pop_front();
    isConfiguring = false;
    isPublishDue = true;
}

void CanopenWork::breakOffConfiguration()
{
    lss.cancel();
    const auto outcome = lss.takeOutcome();
    if (isConfiguring)
        endConfiguration(outcome.value_or(canopen::LssOutcome()));
}

} // namespace codewheel
