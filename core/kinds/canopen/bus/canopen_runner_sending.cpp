// SPDX-License-Identifier: GPL-3.0-or-later
// What goes out: by hand first, then what configures or searches, then the nodes in turn.
#include "kinds/canopen/bus/canopen_runner_private.h"
#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/protocol/sdo_abort.h"

#include <algorithm>

namespace codewheel {
namespace {

using canopen::SdoOutcome;

// A driver that wants something, and then does not, is asked again.
constexpr Instant betweenQuestions = std::chrono::milliseconds(1);

// Of a serial adapter to send a frame, until it is told that its fate is not known.
constexpr std::uint64_t leastAttempts = 16;

constexpr std::uint16_t producerTime = 0x1017;
constexpr int firstPdoIndex = 0x1800;
constexpr int predefinedPdos = 4;
constexpr std::uint32_t identifierBits = 0x1FFF'FFFF;
constexpr std::uint32_t pdoIsOff = 0x8000'0000;

// The identifier of a TPDO.
bool isPdoIdentifier(const canopen::SdoObject &object)
{
    return object.index >= 0x1800 && object.index <= 0x19FF && object.sub == 1;
}

} // namespace

void CanopenWork::send()
{
    isQueueFull = false;
    while (state.connected) {
        if (!waiting)
            waiting = nextFrame();
        if (!waiting)
            return;
        const auto taken = link.send(waiting->frame);
        if (!taken) {
            linkIsGone(taken.error());
            return;
        }
        isQueueFull = !*taken;
        if (isQueueFull) { // until something has gone out
            if (waiting->by == Outgoing::By::scan) {
                waiting.reset();
                scan->queueFull(link.now());
            }
            return;
        }
        waiting->at = link.now();
        noteRequest(*waiting);
        underWay.push_back(*std::exchange(waiting, std::nullopt));
    }
}

std::optional<CanopenWork::Outgoing> CanopenWork::nextFrame()
{
    using By = Outgoing::By;
    const Instant now = link.now();
    if (!stops.empty()) {
        const int node = *stops.begin();
        stops.erase(stops.begin());
        return Outgoing{canopen::NmtRequest{canopen::NmtCommand::stop, node}.frame(), By::alarmStop, node};
    }
    if (!state.operate)
        return std::nullopt;
    if (!typed.empty()) {
        const CanFrame frame = typed.front();
        typed.pop_front();
        return Outgoing{frame, By::typed};
    }
    if (auto frame = nextOfConfiguration())
        return frame;
    if (!commands.empty())
        return nextCommand();
    if (scan)
        if (const auto frame = scan->next(now))
            return Outgoing{*frame, By::scan, canopen::CobId::of(frame->id)->node, {}, true};
    for (int i = 0; i < canopen::lastNode; ++i) {
        const int number = (lastAsked + i) % canopen::lastNode + 1;
        if (!nodes.at(static_cast<std::size_t>(number)) || nodeAt(number).dueAt > now)
            continue;
        if (auto frame = nextOf(number)) {
            lastAsked = number;
            return frame;
        }
    }
    return nextCommand();
}

std::optional<CanopenWork::Outgoing> CanopenWork::nextCommand()
{
    if (commands.empty())
        return std::nullopt;
    const Outgoing command = commands.front();
    commands.pop_front();
    return command;
}

std::optional<CanopenWork::Outgoing> CanopenWork::nextOfConfiguration()
{
    const Instant now = link.now();
    if (const auto outcome = lss.takeOutcome())
        endConfiguration(*outcome);
    if (!isConfiguring && !configurations.empty()) {
        isConfiguring = true;
        lss.begin(configurations.front(), now);
    }
    const auto frame = lss.isBusy() ? lss.next(now) : std::nullopt;
    if (!frame)
        return std::nullopt;
    return Outgoing{.frame = *frame, .by = Outgoing::By::configuration, .number = lss.given()};
}

std::optional<CanopenWork::Outgoing> CanopenWork::nextOf(int number)
{
    Node &node = nodeAt(number);
    beginRequest(number);
    const auto frame = node.client.next(link.now());
    settle(number);
    if (!frame) {
        if (!node.client.isBusy() && !node.request)
            node.dueAt = std::max(node.dueAt, link.now() + betweenQuestions);
        return std::nullopt;
    }
    const bool isAutomatic = !node.isTypedUnderWay && node.device && !driver(*node.device)->busy();
    node.isPollUnderWay = isAutomatic;
    return Outgoing{*frame, Outgoing::By::transfer, number, {}, isAutomatic, node.client.given()};
}

// Only where nothing is under way with the node.
void CanopenWork::beginRequest(int number)
{
    Node &node = nodeAt(number);
    if (node.client.isBusy() || node.request)
        return;
    if (!node.typed.empty()) {
        node.isTypedUnderWay = true;
        node.client.begin(node.typed.front(), link.now());
        return;
    }
    if (!mayAsk(node))
        return;
    node.request = driver(*node.device)->next(link.now());
    collect(*node.device);
    if (!node.request)
        return;
    if (const auto *transfer = std::get_if<canopen::SdoRequest>(&*node.request))
        node.client.begin(*transfer, link.now());
    else
        commands.push_back(
            {std::get<canopen::NmtRequest>(*node.request).frame(), Outgoing::By::driver, number});
}

// A job that has begun goes to its end.
bool CanopenWork::mayAsk(const Node &node) const
{
    if (!node.device || !state.operate || !state.running)
        return false;
    return driver(*node.device)->busy() || (!state.isHeldBack() && !scan);
}

void CanopenWork::settle(int number)
{
    Node &node = nodeAt(number);
    const Instant now = link.now();
    if (const auto outcome = node.client.takeOutcome())
        ended(node, *outcome);
    node.dueAt = node.client.wakesAt().value_or(Instant::max());
    if (node.client.isBusy() || node.request)
        return;
    if (!node.typed.empty())
        node.dueAt = now;
    else if (mayAsk(node))
        if (const auto wakes = driver(*node.device)->wakesAt())
            node.dueAt = std::min(node.dueAt, *wakes);
}

void CanopenWork::ended(Node &node, const SdoOutcome &outcome)
{
    if (outcome.kind != SdoOutcome::Kind::notSent)
        node.answers = outcome.kind != SdoOutcome::Kind::noAnswer;
    if (std::exchange(node.isTypedUnderWay, false)) {
        const canopen::SdoRequest request = node.typed.front();
        node.typed.pop_front();
        learn(node, request, outcome);
        if (node.device) {
            driver(*node.device)->observe(request, outcome, link.now());
            collect(*node.device);
        }
        tellEvent(TransferEnded{request, outcome});
    } else if (node.request) {
        if (const auto *request = std::get_if<canopen::SdoRequest>(&*node.request))
            learn(node, *request, outcome);
        answerDriver(node, outcome);
    }
    isPublishDue = true;
}

void CanopenWork::answerDriver(Node &node, const SdoOutcome &outcome)
{
    const canopen::NodeRequest request = *std::exchange(node.request, std::nullopt);
    if (!node.device) // removed meanwhile
        return;
    driver(*node.device)->answered(request, outcome, link.now());
    node.watch.setMayBeSilent(driver(*node.device)->mayBeSilent(), link.now());
    collect(*node.device);
    look(*node.device);
}

// What has to be known of a node to hear it right.
void CanopenWork::learn(Node &node, const canopen::SdoRequest &request, const SdoOutcome &outcome)
{
    const bool isRead = outcome.kind == SdoOutcome::Kind::read;
    if (request.object.index == producerTime && !request.value && canopen::isMissing(outcome))
        node.watch.setProducerTime(Instant(), link.now());
    if (!isRead && outcome.kind != SdoOutcome::Kind::written)
        return;
    const std::uint32_t number = canopen::numberOf(isRead ? outcome.value : *request.value);
    if (request.object.index == producerTime)
        node.watch.setProducerTime(std::chrono::milliseconds(number), link.now());
    if (isPdoIdentifier(request.object))
        learnPdo(node, request.node, request.object.index - firstPdoIndex + 1, number);
}

void CanopenWork::learnPdo(Node &node, int number, int pdo, std::uint32_t told)
{
    const std::uint32_t identifier = told & identifierBits;
    const auto cob = canopen::CobId::of(identifier);
    const bool isOff = (told & pdoIsOff) != 0;
    if (!isOff && cob && cob->node == 0) // NMT and SYNC are no PDOs, whatever it says
        return;
    node.pdos[pdo] = isOff ? 0 : identifier;
    std::vector<std::uint32_t> identifiers;
    for (int each = 1; each <= predefinedPdos; ++each)
        if (!node.pdos.contains(each))
            identifiers.push_back(canopen::CobId{canopen::CobId::Service::tpdo, number, each}.identifier());
    std::erase_if(pdoSenders, [number](const auto &its) { return its.second == number; });
    for (const auto &[each, its] : node.pdos)
        if (its != 0) {
            identifiers.push_back(its);
            pdoSenders[its] = number;
        }
    node.watch.setTpdos(std::move(identifiers));
    if (isOff)
        return;
    if (node.device)
        listeners[identifier].insert(*node.device);
}

void CanopenWork::fate(CanFate fate)
{
    using By = Outgoing::By;
    if (underWay.empty())
        return;
    const Outgoing sent = std::move(underWay.front());
    underWay.pop_front();
    const bool isRefused = fate == CanFate::refused;
    ++(isRefused ? figures.notSent : figures.sent);
    if (fate == CanFate::done)
        isDisturbed = false;
    else if (!isRefused && isDisturbed)
        figures.notAcknowledged += leastAttempts;
    if (!isRefused)
        wasSent(sent);
    switch (sent.by) {
    case By::transfer:
        nodeAt(sent.node).client.fate(sent.number, fate, link.now());
        settle(sent.node);
        break;
    case By::driver:
        if (const auto &its = nodeAt(sent.node).request;
            its && std::holds_alternative<canopen::NmtRequest>(*its))
            answerDriver(nodeAt(sent.node),
                         {.kind = isRefused ? SdoOutcome::Kind::notSent : SdoOutcome::Kind::written});
        settle(sent.node);
        break;
    case By::typed:
        tellEvent(FrameSent{sent.frame, fate, {}});
        break;
    case By::configuration:
        lss.fate(sent.number, fate, link.now());
        break;
    case By::alarmStop:
        if (isRefused)
            stops.insert(sent.node);
        break;
    case By::scan:
        if (scan)
            scan->fate(sent.node, fate, link.now());
        break;
    }
    const auto isStop = [](const Outgoing &each) { return each.by == By::alarmStop; };
    state.stopsWait =
        !stops.empty() || (waiting && isStop(*waiting)) || std::ranges::any_of(underWay, isStop);
}

void CanopenWork::wasSent(const Outgoing &sent)
{
    CanFrame frame = sent.frame;
    frame.time = sent.at;
    load.add(frame);
    tellRow(frame, sent.at,
            {.isSent = true, .isTyped = sent.by == Outgoing::By::typed, .isAutomatic = sent.isAutomatic});
    const auto cob = canopen::CobId::of(frame.id);
    if (cob && cob->service == canopen::CobId::Service::sdoRequest && sent.by == Outgoing::By::typed)
        hear(nodeAt(cob->node), frame, false);
    if (cob && cob->service == canopen::CobId::Service::nmt) {
        if (const auto command = canopen::NmtRequest::read(frame.data()))
            noteCommand(*command, true);
        for (const auto &node : nodes)
            if (node)
                node->watch.take(frame, sent.at);
        if (sent.by != Outgoing::By::driver)
            showToDrivers(frame, 0);
    }
}

// Whose answer, or the boot-up behind which, may come before it is told that the request was sent.
void CanopenWork::noteRequest(const Outgoing &request)
{
    const auto cob = canopen::CobId::of(request.frame.id);
    if (const auto command = canopen::NmtRequest::read(request.frame.data());
        command && cob && cob->service == canopen::CobId::Service::nmt)
        for (const auto &node : nodes)
            if (node)
                node->watch.mayBeReset(*command, request.at);
    if (!cob || cob->service != canopen::CobId::Service::sdoRequest)
        return;
    Node &node = nodeAt(cob->node);
    node.watch.take(request.frame, request.at);
    node.typedFrames += request.by == Outgoing::By::typed ? 1 : 0;
}

// Which nodes an ALARM STOP stops. What a node was told to is kept even if it was never heard.
void CanopenWork::noteCommand(const canopen::NmtRequest &command, bool isOurs)
{
    if (command.node >= 1 && command.node <= canopen::lastNode)
        nodeAt(command.node);
    if (command.command == canopen::NmtCommand::start) {
        if (isOurs)
            started.insert(command.node);
    } else if (command.node == 0) {
        started.clear();
    } else {
        started.erase(command.node);
    }
}

} // namespace codewheel
