// SPDX-License-Identifier: GPL-3.0-or-later
// What comes in: answers to their transfers, everything else to the drivers and to what watches the nodes.
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"
#include "kinds/canopen/protocol/canopen_refusals.h"

#include <algorithm>
#include <cmath>

namespace codewheel {
namespace {

using Service = canopen::CobId::Service;

constexpr Instant untilQueueIsFreer = std::chrono::milliseconds(1);
constexpr Instant betweenLooks = std::chrono::milliseconds(100); // at the state of the controller
constexpr double lowLoad = 0.75;
constexpr std::uint32_t nobodyAcknowledged = 0x020; // linux/can/error.h

} // namespace

Instant CanopenWork::wakesAt(Instant until) const
{
    const Instant now = link.now();
    Instant wakes = std::min(until, statusAt);
    if (isQueueFull)
        return std::min(until, now + untilQueueIsFreer);
    const auto at = [&](std::optional<Instant> when) {
        if (when)
            wakes = std::min(wakes, *when);
    };
    if (!state.operate)
        return std::max(wakes, now);
    for (const auto &node : nodes)
        if (node)
            at(node->dueAt);
    if (lss.isBusy())
        at(lss.wakesAt());
    if (scan)
        at(scan->wakesAt());
    return std::max(wakes, now);
}

void CanopenWork::receive(Instant until)
{
    auto news = link.receive(wakesAt(until));
    lookedAt = link.now();
    if (!news) {
        linkIsGone(news.error());
        return;
    }
    const bool hasRefused = std::ranges::count(news->fates, CanFate::refused) > 0;
    for (const CanFate each : news->fates)
        fate(each);
    for (const CanFrame &frame : news->frames)
        take(frame);
    if (hasRefused)
        statusAt = link.now();
    lookAtBus();
}

void CanopenWork::take(const CanFrame &frame)
{
    const Instant now = frame.time.value_or(link.now());
    isPublishDue = true;
    load.add(frame);
    const auto cob = frame.isExtended || frame.isError ? std::nullopt : canopen::CobId::of(frame.id);
    const bool isAnswer = cob && cob->service == Service::sdoAnswer;
    const bool isPdo = cob && cob->service == Service::tpdo;
    const int number = isPdo ? senderOf(*cob, frame.id) : cob ? cob->node : 0;
    const Node *node = number != 0 ? nodes.at(static_cast<std::size_t>(number)).get() : nullptr;
    const bool isPolled = isAnswer && node != nullptr && node->device && !node->isTypedUnderWay &&
                          (node->isPollUnderWay || !driver(*node->device)->busy());
    tellRow(frame, now, {.isAutomatic = isPolled || isPdo || (cob && cob->service == Service::sync)});
    if (frame.isError) {
        takeError(frame);
        return;
    }
    if (scan)
        scan->hear(link.now());
    ++figures.received;
    figures.notAcknowledged = 0;
    isDisturbed = false;
    figures.extended += frame.isExtended ? 1 : 0;
    if (std::exchange(state.onlyJ1939, figures.isOnlyJ1939()) != figures.isOnlyJ1939())
        settleAll();
    takeOfOthers(frame);
    if (cob && cob->service == Service::sync && !frame.isRemote)
        sync.take(now);
    if (number != 0) {
        Node &its = nodeAt(number);
        const int bootUps = its.watch.bootUps();
        its.watch.take(frame, now);
        if (its.watch.bootUps() != bootUps) {
            started.erase(number);
            its.isDoubledTold = false;
        }
        compareNode(number);
        if (cob->service != Service::sdoRequest && cob->service != Service::rpdo && !frame.isRemote)
            its.heardAt = now;
        if (isPdo && !frame.isRemote)
            its.answers = true;
    } else if (cob && cob->service == Service::nmt) {
        for (const auto &each : nodes)
            if (each)
                each->watch.take(frame, now);
    }
    if (isAnswer || (cob && cob->service == Service::sdoRequest))
        hear(nodeAt(number), frame, isAnswer);
    if (isAnswer)
        takeAnswer(number, frame);
    else if (cob && cob->service == Service::lssAnswer)
        lss.take(frame, now);
    else
        showToDrivers(frame, number);
}

// Transfers of others tell of the node as well.
void CanopenWork::hear(const Node &node, const CanFrame &frame, bool isAnswer)
{
    const auto sdo =
        isAnswer ? canopen::SdoFrame::answer(frame.data()) : canopen::SdoFrame::request(frame.data());
    if (!sdo || !node.device || driver(*node.device) == nullptr)
        return;
    driver(*node.device)->hear(*sdo);
    collect(*node.device);
}

// As the nodes have told; that with this number where none has told otherwise. 0: nobody.
int CanopenWork::senderOf(const canopen::CobId &cob, std::uint32_t identifier) const
{
    if (const auto told = pdoSenders.find(identifier); told != pdoSenders.end())
        return told->second;
    const auto &own = nodes.at(static_cast<std::size_t>(cob.node));
    return own && own->pdos.contains(cob.number) ? 0 : cob.node;
}

void CanopenWork::takeError(const CanFrame &frame)
{
    constexpr std::uint32_t onlyArbitration = 0x02;
    ++figures.errorFrames;
    isDisturbed = isDisturbed || frame.id != onlyArbitration;
    if ((frame.id & nobodyAcknowledged) != 0)
        ++figures.notAcknowledged;
    statusAt = link.now();
}

// One that nobody asked for belongs to another master, and is not taken. What a search asks for may have been
// asked for before: to its client the answer is late.
void CanopenWork::takeAnswer(int number, const CanFrame &frame)
{
    Node &node = nodeAt(number);
    const std::uint64_t foreign = node.client.foreignAnswers();
    const std::uint64_t late = node.client.lateAnswers();
    node.client.take(frame, link.now());
    const bool isLate = node.client.lateAnswers() != late;
    if (isLate && (!scan || !scan->take(frame, link.now())))
        ++figures.lateAnswers;
    if (node.client.foreignAnswers() != foreign) {
        if (node.typedFrames > 0)
            --node.typedFrames;
        else if (!scan || !scan->take(frame, link.now()))
            ++figures.answersOfOthers;
    }
    settle(number);
}

void CanopenWork::takeOfOthers(const CanFrame &frame)
{
    if (state.otherMaster.take(frame)) {
        tell({.severity = Severity::attention,
              .id = CanopenBusMessageId::otherMasterHeard,
              .arguments = {state.otherMaster.argument()}});
        publish();
    }
    if (frame.id != 0 || frame.isExtended || frame.isRemote)
        return;
    if (const auto command = canopen::NmtRequest::read(frame.data()))
        noteCommand(*command, false);
}

// To the one with this number, to those who send PDOs with this identifier, or, of no node, to all.
void CanopenWork::showToDrivers(const CanFrame &frame, int number)
{
    std::optional<std::size_t> own;
    if (number != 0)
        own = nodeAt(number).device;
    if (own)
        showToDriver(*own, frame);
    if (const auto others = listeners.find(frame.id); others != listeners.end()) {
        for (const std::size_t device : others->second)
            if (own != device)
                showToDriver(device, frame);
    } else if (number == 0 && !frame.isExtended) {
        for (std::size_t device = 0; device < drivers.size(); ++device)
            showToDriver(device, frame);
    }
}

void CanopenWork::showToDriver(std::size_t device, const CanFrame &frame)
{
    if (driver(device) == nullptr)
        return;
    driver(device)->take(frame, frame.time.value_or(link.now()));
    collect(device);
    look(device);
    settle(driver(device)->node());
}

void CanopenWork::compareNode(int number)
{
    Node &node = nodeAt(number);
    const canopen::Heartbeat heartbeat = node.watch.heartbeat(link.now());
    const canopen::Heartbeat before = std::exchange(node.heartbeat, heartbeat);
    if (heartbeat != before) {
        if (heartbeat == canopen::Heartbeat::lost)
            tellOfNode(number, Severity::fault, CanopenBusMessageId::heartbeatLost);
        else if (before == canopen::Heartbeat::lost)
            tellOfNode(number, Severity::information, CanopenBusMessageId::heartbeatBack);
        isPublishDue = true;
    }
    if (!node.watch.isDoubled())
        return;
    if (!std::exchange(node.isDoubledTold, true))
        tellOfNode(number, Severity::fault, CanopenBusMessageId::nodeDoubled);
    if (node.device)
        stopJob(*node.device, canopen::nodeIsDoubled(number));
}

void CanopenWork::lookAtScan()
{
    if (!scan)
        return;
    if (scan->isDone() || scan->isStuck(link.now())) {
        endScan(!scan->isDone());
        return;
    }
    std::vector<canopen::FoundNode> found = scan->found();
    if (std::exchange(foundTold, found.size()) != found.size())
        tellEvent(NodesScanned{scan->progress(), std::move(found)});
}

void CanopenWork::lookAtBus()
{
    const Instant now = link.now();
    if (now < statusAt)
        return;
    statusAt = now + betweenLooks;
    for (int number = 1; number <= canopen::lastNode; ++number)
        if (nodes.at(static_cast<std::size_t>(number)))
            compareNode(number);
    const CanStatus before = std::exchange(status, link.status());
    if (status.rate != before.rate)
        load = CanLoad(rateNow());
    figures.load = load.share(now);
    const bool isFull = figures.load >= (isLoadTold ? lowLoad : CanopenFigures::highLoad);
    if (isFull && !isLoadTold)
        tell({.severity = Severity::attention,
              .id = CanopenBusMessageId::loadHigh,
              .arguments = {static_cast<std::int64_t>(std::lround(figures.load * 100))}});
    isLoadTold = isFull;
    isPublishDue = true;
    if (status.state == CanState::busOff && before.state != CanState::busOff)
        linkIsGone({RefusalKind::link, CanRefusalId::busOff, {linkArgument(link)}});
}

} // namespace codewheel
