// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/bus_session_private.h"

#include <algorithm>

namespace codewheel {
namespace {

// Not by its make, which no master can tell.
bool isSameDevice(const Participant &before, const Participant &found)
{
    return before.number == found.number && before.deviceCode == found.deviceCode &&
           before.inWords == found.inWords && before.outWords == found.outWords &&
           (found.deviceKey.isEmpty() || found.deviceKey == before.deviceKey);
}

} // namespace

// What is unchanged keeps its driver, session and channel; only its place may be another.
RingRunner::Drivers BusSession::Private::takeOver(BusSession &bus, RingStructure found,
                                                  RingRunner::Drivers drivers)
{
    const RingStructure before = std::exchange(structure, std::move(found));
    auto sessionsBefore = std::exchange(sessions, {});
    auto channelsBefore = std::exchange(channels, {});
    RingRunner::Drivers taken(structure.size());
    sessions.resize(structure.size());
    renamings.assign(structure.size(), 0);
    for (std::size_t i = 0; i < structure.size(); ++i) {
        Participant &participant = structure[i];
        const auto same = std::ranges::find_if(
            before, [&](const Participant &other) { return isSameDevice(other, participant); });
        if (same == before.end()) {
            channels.push_back(makeChannel(bus, participant));
            taken[i] = makeSession(bus, i, describe(participant));
            continue;
        }
        const auto j = static_cast<std::size_t>(same - before.begin());
        participant.deviceKey = same->deviceKey;
        taken[i] = std::move(drivers[j]);
        channels.push_back(std::move(channelsBefore[j]));
        sessions[i] = std::move(sessionsBefore[j]);
        if (sessions[i])
            sessions[i]->moveIndexTo(i);
    }
    std::ranges::move(sessionsBefore, std::back_inserter(retired));
    std::ranges::move(channelsBefore, std::back_inserter(retiredChannels));
    return taken;
}

void BusSession::takeOfMaster(const MasterEvent &event)
{
    if (const auto *progress = std::get_if<ReadInProgress>(&event)) {
        Q_EMIT readInProgressed(progress->devices);
    } else if (const auto *kept = std::get_if<KeptConfigurationTold>(&event)) {
        Q_EMIT keptConfigurationTold(kept->configuration);
    } else {
        const Result<RingStructure> &found = std::get<ReadInEnded>(event).found;
        if (found && !isSameRing(*found, d->structure)) {
            d->otherRing = *found;
            return;
        }
        d->readingIn = false;
        if (found)
            Q_EMIT readInEnded();
        else
            Q_EMIT readInFailed(found.error());
    }
}

// Between two runners. What comes of a handler meanwhile, ALARM STOP above all, is carried out by the old
// one.
void BusSession::useOtherRing()
{
    const bool hasThread = d->thread != nullptr;
    d->thread.reset();
    do {
        d->runner->finish(d->latest->at);
        d->fetch();
        dispatchAll();
        if (!d->runner) // closed by a handler
            return;
    } while (!d->events.empty());
    const std::shared_ptr<const Snapshot> before = d->latest;
    d->latestIsNew = false;

    const auto readBack = d->link->readBackOut();
    RingStructure found = *std::exchange(d->otherRing, std::nullopt);
    std::vector<Word> out = readBack.value_or(std::vector<Word>());
    out.resize(found.size());
    auto drivers = d->takeOver(*this, std::move(found), d->runner->takeDrivers());
    d->runner = std::make_unique<RingRunner>(*d->link, d->structure, std::move(drivers), out);
    if (before->operate)
        d->runner->beginOperating();
    if (d->link->master()->status().state == MasterState::active) // and not after ALARM STOP
        post(command::StartBus{});
    showNewRing(*before, out);
    d->readingIn = false;
    d->crcHistory.clear();
    Q_EMIT structureChanged();
    Q_EMIT nodesChanged();
    Q_EMIT readInEnded();
    if (hasThread)
        startThread(before->period);
}

void BusSession::showNewRing(const Snapshot &before, const std::vector<Word> &out)
{
    auto shown = std::make_shared<Snapshot>();
    shown->at = before.at;
    shown->state = MasterState::active;
    shown->operate = before.operate;
    shown->period = before.period;
    for (const Word word : out)
        shown->devices.push_back({.out = word, .reading = {}});
    shown->master = std::make_shared<const MasterStatus>(d->link->master()->status());
    d->latest = std::move(shown);
    showLatest();
}

const MasterStatus *BusSession::master() const
{
    return d->latest->master.get();
}

const CrcHistory &BusSession::crcHistory() const
{
    return d->crcHistory;
}

void BusSession::readIn()
{
    if (!d->runner)
        return;
    d->readingIn = true;
    post(command::ReadIn{});
}

bool BusSession::isReadingIn() const
{
    return d->readingIn;
}

void BusSession::switchSegment(int segment, bool on)
{
    post(command::SwitchSegment{segment, on});
}

void BusSession::confirmDiagnostics()
{
    post(command::ConfirmDiagnostics{});
}

void BusSession::keepConfiguration(const KeptConfiguration &configuration)
{
    post(command::KeepConfiguration{configuration});
}

void BusSession::askKeptConfiguration()
{
    post(command::AskKeptConfiguration{.onConnecting = false});
}

} // namespace codewheel
