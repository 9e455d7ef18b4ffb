// SPDX-License-Identifier: GPL-3.0-or-later
// A link that goes away and comes back, or is used otherwise.
#include "can/can_refusals.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::chrono::seconds untilOpenedAgain{1}; // of a link that is gone
constexpr int mostInterruptions = 20;               // of its opening
constexpr Instant forLastStops = std::chrono::milliseconds(100);

bool isAboutWatching(const Refusal &why)
{
    return why.id == CanRefusalId::watchNotSure;
}

} // namespace

// Each command that is posted meanwhile interrupts it.
Result<void> CanopenRunner::Private::openLink(CanUse wanted)
{
    auto opened = link.open(wanted);
    for (int i = 0; i < mostInterruptions && !opened && opened.error().kind == RefusalKind::stopped; ++i)
        opened = link.open(wanted);
    return opened;
}

bool CanopenRunner::Private::reopen(CanUse wanted)
{
    const auto opened = openLink(wanted);
    if (!opened) {
        linkIsGone(opened.error());
        return false;
    }
    use = wanted;
    statusAt = link.now();
    return true;
}

// An ALARM STOP is sent in Watch, too.
void CanopenRunner::Private::useAsWanted()
{
    const bool mustSend = state.operate || !stops.empty();
    const bool isSending = waiting || !underWay.empty();
    const CanUse wanted = mustSend || isSending ? CanUse::operate : CanUse::watch;
    if (wanted != use)
        reopen(wanted);
}

void CanopenRunner::Private::sendLastStops()
{
    const Instant end = link.now() + forLastStops;
    while (state.connected && state.stopsWait && link.now() < end) {
        useAsWanted();
        send();
        if (state.connected)
            receive(end);
    }
}

void CanopenRunner::Private::linkIsGone(const Refusal &why)
{
    state.connected = false;
    state.whyLost = why;
    reopenAt = link.now() + untilOpenedAgain;
    notBack = why;
    tell({.severity = Severity::fault, .refusal = why});
    if (isAboutWatching(why))
        tellEvent(WatchNotSure{why});
    keepStops();
    if (state.stopsWait)
        tell({.severity = Severity::fault, .id = CanopenBusMessageId::stopsNotSent});
    stopJobs(why);
    state.operate = false;
    dropTyped();
    leaveOff();
    endScan(true);
    for (std::size_t device = 0; device < drivers.size(); ++device)
        if (driver(device)) {
            driver(device)->lost(link.now());
            collect(device);
        }
    for (int number = 1; number <= canopen::lastNode; ++number)
        if (auto &node = nodes.at(static_cast<std::size_t>(number))) {
            node->watch = canopen::NodeWatch(number);
            node->pdos.clear();
        }
    started.clear();
    listeners.clear();
    pdoSenders.clear();
    status = {};
    link.close();
    publish();
}

// A node that is stopped twice is stopped.
void CanopenRunner::Private::keepStops()
{
    for (const Outgoing &sent : underWay)
        if (sent.by == Outgoing::By::alarmStop)
            stops.insert(sent.node);
    if (waiting && waiting->by == Outgoing::By::alarmStop)
        stops.insert(waiting->node);
    state.stopsWait = !stops.empty();
}

// What was sent may have been carried out, though nobody will see its answer.
void CanopenRunner::Private::leaveOff()
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

void CanopenRunner::Private::waitForLink(Instant until)
{
    carryOutCommands();
    if (link.now() < reopenAt)
        link.wait(std::min(until, reopenAt));
    else
        tryToReopen();
}

// That it is missing was reported. Anything else in the way is reported once.
void CanopenRunner::Private::tryToReopen()
{
    reopenAt = link.now() + untilOpenedAgain;
    const auto opened = openLink(CanUse::watch);
    if (!opened) {
        const bool isNew = notBack != opened.error();
        notBack = opened.error();
        if (!isNew)
            return;
        state.whyLost = opened.error();
        tell({.severity = Severity::attention, .refusal = opened.error()});
        if (isAboutWatching(opened.error()))
            tellEvent(WatchNotSure{opened.error()});
        publish();
        return;
    }
    use = CanUse::watch;
    state.connected = true;
    state.whyLost.reset();
    state.otherMaster = {};
    state.besideOthers = false;
    statusAt = link.now();
    tell({.id = CanopenBusMessageId::back, .arguments = {linkArgument(link)}});
    publish();
}

} // namespace codewheel
