// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_runner_private.h"
#include "kinds/interbus/ring/send_permission.h"

#include <algorithm>

namespace codewheel {

bool RingRunner::Private::reaches(MasterService service)
{
    if (!master)
        refuseOfRing({RefusalKind::notSupported,
                      RingRefusalId::masterServiceNotSupported,
                      {masterServiceName(service)}});
    return master != nullptr;
}

bool RingRunner::Private::mayUse(MasterService service)
{
    if (!reaches(service))
        return false;
    const auto allowed = mayChangeRing(ring);
    if (!allowed)
        refuseOfRing(allowed.error());
    return allowed.has_value();
}

// 0711 if no configuration is active, then 0701.
Result<void> RingRunner::Private::startTransfer()
{
    if (!master || master->status().state == MasterState::run)
        return {};
    if (master->status().state != MasterState::active) {
        auto active = master->activateConfiguration();
        if (!active)
            return tl::unexpected(active.error());
        takeActive(*active);
        if (ringIsOther) {
            tell(0, MasterEvent(ReadInEnded{{}}));
            return {};
        }
    }
    return master->startDataTransfer();
}

// A ring other than ours waits for UseRing, and runs then.
void RingRunner::Private::takeActive(const RingStructure &active)
{
    ringIsOther = !isSameRing(active, structure);
    runsAgain = ringIsOther;
    if (!ringIsOther)
        return;
    tell(0, found(active, link.readBackOut().value_or(std::vector<Word>())));
}

Result<void> RingRunner::Private::endActiveConfiguration()
{
    if (master->status().state == MasterState::run)
        if (auto stopped = master->stopDataTransfer(); !stopped)
            return stopped;
    if (master->status().state == MasterState::ready)
        return {};
    masterWatch.leftByService();
    return master->deactivateConfiguration();
}

void RingRunner::Private::carryOut(command::ReadIn)
{
    if (readingIn || ringIsOther)
        return;
    if (!reaches(MasterService::createConfiguration)) {
        endReadIn(refuse(RefusalKind::notSupported, RingRefusalId::masterServiceNotSupported,
                         {masterServiceName(MasterService::createConfiguration)}));
        return;
    }
    if (const auto allowed = mayChangeRing(ring); !allowed) {
        refuseOfRing(allowed.error());
        endReadIn(tl::unexpected(allowed.error()));
        return;
    }
    if (const auto ended = endActiveConfiguration(); !ended) {
        refuseOfRing(ended.error());
        endReadIn(tl::unexpected(ended.error()));
        return;
    }
    leaveRun(MasterState::ready);
    readingIn = true;
}

void RingRunner::Private::readInStep()
{
    auto cycle = master->createConfiguration();
    if (!cycle) {
        refuseOfRing(cycle.error());
        endReadIn(tl::unexpected(cycle.error()));
    } else {
        tell(0, MasterEvent(ReadInProgress{static_cast<int>(cycle->found.size())}));
        if (cycle->complete)
            endReadIn(cycle->found);
    }
    showStandingWords();
}

// The same ring runs again at once.
void RingRunner::Private::endReadIn(const Result<RingStructure> &read)
{
    readingIn = false;
    if (read) {
        tellOfRing({.severity = read->empty() ? Severity::attention : Severity::information,
                    .id = RingMessageId::ringRead,
                    .arguments = {static_cast<std::int64_t>(read->size())}});
        ring.state = MasterState::active;
        takeActive(*read);
    }
    tell(0, MasterEvent(ReadInEnded{read ? Result<void>() : tl::unexpected(read.error())}));
    if (read && !ringIsOther)
        carryOut(command::StartBus{});
}

void RingRunner::Private::carryOut(const command::SwitchSegment &c)
{
    if (!mayUse(MasterService::switchSegment))
        return;
    if (const auto switched = master->switchSegment(c.segment, c.on); !switched)
        refuseOfRing(switched.error());
    lookAtMaster();
}

// What comes back at once is reported again.
void RingRunner::Private::carryOut(command::ConfirmDiagnostics)
{
    if (!mayUse(MasterService::confirmDiagnostics))
        return;
    if (const auto confirmed = master->confirmDiagnostics(); confirmed) {
        tellOfRing({.id = RingMessageId::diagnosticsConfirmed});
        masterWatch.confirmedByService();
    } else {
        refuseOfRing(confirmed.error());
    }
    lookAtMaster();
}

void RingRunner::Private::carryOut(const command::KeepConfiguration &c)
{
    if (!mayUse(MasterService::loadConfiguration))
        return;
    if (const auto kept = master->keepConfiguration(c.configuration); !kept) {
        refuseOfRing(kept.error());
        return;
    }
    tellOfRing({.id = RingMessageId::configurationKept,
                .arguments = {c.configuration.fileName,
                              static_cast<std::int64_t>(c.configuration.structure.size())}});
    carryOut(command::AskKeptConfiguration{.onConnecting = false});
}

void RingRunner::Private::carryOut(const command::AskKeptConfiguration &c)
{
    if (c.onConnecting && !master)
        return;
    if (!reaches(MasterService::readConfiguration))
        return;
    const auto kept = master->keptConfiguration();
    if (!kept && kept.error().id != RingRefusalId::noConfiguration) {
        refuseOfRing(kept.error());
        return;
    }
    if (c.onConnecting && kept)
        tellOfRing({.id = RingMessageId::configurationFound,
                    .arguments = {kept->fileName, static_cast<std::int64_t>(kept->structure.size())}});
    else if (c.onConnecting)
        tellOfRing({.id = RingMessageId::configurationNone});
    tell(0, MasterEvent(KeptConfigurationTold{kept ? std::optional(*kept) : std::nullopt}));
}

void RingRunner::Private::idle()
{
    if (master)
        master->idleCycle();
    showStandingWords();
}

void RingRunner::Private::lookAtMaster()
{
    if (!master || !ring.connected)
        return;
    if (master->statusChanges() != seenOfMaster)
        lookAtStatus();
    tellOfRing(masterWatch.lookAtTime(ring.at));
}

void RingRunner::Private::lookAtStatus()
{
    seenOfMaster = master->statusChanges();
    const auto status = std::make_shared<const MasterStatus>(master->status());
    ring.master = status;
    if (status->state != MasterState::ready)
        ring.refusedStart.reset();
    if (ringIsOther) // what it says is about devices we do not have
        return;
    std::vector<NodeId> numbers;
    for (const RingDevice &participant : structure)
        numbers.push_back(participant.number);
    tellOfRing(masterWatch.look(*status, numbers, ring.at));
    if (ring.state == MasterState::run && status->state != MasterState::run)
        leaveRun(status->state);
    else
        ring.state = status->state;
    showWhoIsInRing(*status);
}

void RingRunner::Private::showWhoIsInRing(const MasterStatus &status)
{
    const std::size_t devices = std::min(ring.devices.size(), status.devices.size());
    for (std::size_t i = 0; i < devices; ++i) {
        if (ring.devices[i].inRing && !status.devices[i].inRing)
            leaveRing(i);
        ring.devices[i].inRing = status.devices[i].inRing;
    }
}

// What it showed last is no longer a reading, but where it stood then; what was in OUT is not sent again
// automatically.
void RingRunner::Private::leaveRing(std::size_t i)
{
    if (drivers[i] && drivers[i]->busy())
        endJob(i, {RefusalKind::stopped, RefusalId::busStopped, {}});
    std::erase(written, i);
    image[i] = 0;
    Snapshot::Device &device = ring.devices[i];
    const Word in = device.in; // and when that was: a monitor tells it, with its age
    const Word outEdges = device.out;
    const Reading last = device.reading;
    device = {.in = in, .outEdges = outEdges, .reading = {}};
    device.reading.at = last.at;
    device.reading.position = last.position;
}

} // namespace codewheel
