// SPDX-License-Identifier: GPL-3.0-or-later
// A link that goes away and comes back, or is used otherwise.
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"

namespace codewheel {
namespace {

constexpr int mostInterruptions = 20; // of its opening
constexpr Instant forLastStops = std::chrono::milliseconds(100);

bool isAboutWatching(const Refusal &why)
{
    return why.id == CanRefusalId::watchNotSure;
}

} // namespace

// Each command that is posted meanwhile interrupts it.
Result<void> CanopenWork::openFor(CanUse wanted)
{
    auto opened = link.open(wanted);
    for (int i = 0; i < mostInterruptions && !opened && opened.error().kind == RefusalKind::stopped; ++i)
        opened = link.open(wanted);
    return opened;
}

// Once, however often it is opened.
void CanopenWork::tellRemark()
{
    if (const auto remark = link.remark(); remark && !std::exchange(isRemarkTold, true))
        tell({.severity = Severity::attention, .refusal = remark});
}

bool CanopenWork::reopen(CanUse wanted)
{
    const auto opened = openFor(wanted);
    if (!opened) {
        linkIsGone(opened.error());
        return false;
    }
    use = wanted;
    statusAt = link.now();
    tellRemark();
    return true;
}

// An ALARM STOP is sent in Watch, too.
void CanopenWork::useAsWanted()
{
    const bool mustSend = state.operate || !stops.empty();
    const bool isSending = waiting || !underWay.empty();
    const CanUse wanted = mustSend || isSending ? CanUse::operate : CanUse::watch;
    if (wanted != use)
        reopen(wanted);
}

void CanopenWork::sendLast()
{
    const Instant end = link.now() + forLastStops;
    while (state.connected && state.stopsWait && link.now() < end) {
        useAsWanted();
        send();
        if (state.connected)
            receive(end);
    }
    if (state.stopsWait)
        tell({.severity = Severity::fault, .id = CanopenBusMessageId::stopsNotSent});
}

void CanopenWork::tellGone(const Refusal &why)
{
    AskingWork::tellGone(why);
    if (isAboutWatching(why))
        tellEvent(WatchNotSure{why});
    keepStops();
    if (state.stopsWait)
        tell({.severity = Severity::fault, .id = CanopenBusMessageId::stopsNotSent});
}

void CanopenWork::forget()
{
    for (int number = 1; number <= canopen::lastNode; ++number)
        if (auto &node = nodes.at(static_cast<std::size_t>(number))) {
            node->watch.forget();
            node->pdos.clear();
        }
    started.clear();
    listeners.clear();
    pdoSenders.clear();
    sync = {};
    status = {};
}

// A node that is stopped twice is stopped.
void CanopenWork::keepStops()
{
    for (const Outgoing &sent : underWay)
        if (sent.by == Outgoing::By::alarmStop)
            stops.insert(sent.node);
    if (waiting && waiting->by == Outgoing::By::alarmStop)
        stops.insert(waiting->node);
    state.stopsWait = !stops.empty();
}

// What was sent may have been carried out, though nobody will see its answer.
void CanopenWork::leaveOff()
{
    keepStops();
    for (const Outgoing &sent : std::exchange(underWay, {}))
        if (sent.by == Outgoing::By::typed)
            tellEvent(FrameSent{sent.frame, CanFate::notKnown, {}});
    if (const auto unsent = std::exchange(waiting, std::nullopt); unsent && unsent->by == Outgoing::By::typed)
        tellEvent(FrameSent{unsent->frame, CanFate::refused, {}});
    commands.clear();
    for (const auto &node : nodes) {
        if (!node)
            continue;
        node->client.cancel(link.now());
        node->client.takeOutcome();
        node->client.next(link.now()); // nor an abort
        if (node->isTypedUnderWay || node->request)
            ended(*node, {.kind = canopen::SdoOutcome::Kind::noAnswer});
        node->dueAt = Instant::max();
        node->answers = true;
        node->typedFrames = 0;
    }
    breakOffConfiguration();
}

Result<void> CanopenWork::reopenLink()
{
    return openFor(CanUse::watch);
}

void CanopenWork::tellNotBack(const Refusal &why, bool isNew)
{
    if (state.whyLost != why) {
        state.whyLost = why;
        publish();
    }
    if (!isNew)
        return;
    tell({.severity = Severity::attention, .refusal = why});
    if (isAboutWatching(why))
        tellEvent(WatchNotSure{why});
}

void CanopenWork::linkIsBack()
{
    use = CanUse::watch;
    state.otherMaster = {};
    state.besideOthers = false;
    statusAt = link.now();
    tell({.id = CanopenBusMessageId::back, .arguments = {linkArgument(link)}});
}

} // namespace codewheel
