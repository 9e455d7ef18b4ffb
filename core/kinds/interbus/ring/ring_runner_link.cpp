// SPDX-License-Identifier: GPL-3.0-or-later
// A link that is opened, lost and back, and the ring that is found then.
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_runner_private.h"
#include "vocabulary/hex.h"

#include <utility>

namespace codewheel {
namespace {

constexpr std::chrono::seconds betweenOpenings{1}; // of opening a lost link

Refusal ofLink(const Refusal &why)
{
    return {RefusalKind::link, why.id, why.arguments};
}

} // namespace

Result<RingFound> RingRunner::Private::find()
{
    auto there = link.open();
    if (!there)
        return tl::unexpected(there.error());
    auto out = link.readBackOut();
    if (!out && out.error().id == GatewayRefusalId::outNotReadBack) {
        auto nothing = found(*std::move(there), {});
        nothing.outIsKnown = false;
        return nothing;
    }
    if (!out) {
        link.close();
        return tl::unexpected(out.error());
    }
    return found(*std::move(there), *std::move(out));
}

RingFound RingRunner::Private::found(RingStructure there, std::vector<Word> out) const
{
    out.resize(there.size());
    return {std::move(there), std::move(out),
            master ? std::make_shared<const MasterStatus>(master->status()) : nullptr, true, link.figures()};
}

void RingRunner::Private::loseLink(const Refusal &why)
{
    ring.connected = false;
    traceUnansweredWords();
    tellUnheardWords();
    runsAgain = ring.state == MasterState::run;
    leaveRun(MasterState::busFail, ofLink(why));
    ring.operate = false;
    ring.whyLost = ofLink(why);
    ring.outputsAreBlocked = ring.outputsAreBlocked || why.id == GatewayRefusalId::outputsBlocked;
    refuseOfRing(*ring.whyLost);
    if (zerosAreDue)
        tellOfRing({.severity = Severity::attention, .id = RingMessageId::zerosWait});
    link.close();
    reopenAt = link.now() + betweenOpenings; // the last exchange may have taken long
}

void RingRunner::Private::carryOut(command::AcknowledgeWatchdog)
{
    const auto done = ring.connected ? link.acknowledgeWatchdog()
                                     : Result<void>(tl::unexpected(ring.whyLost.value_or(
                                           Refusal{RefusalKind::link, RefusalId::lineClosed, {}})));
    catchUp();
    if (!done) {
        refuseOfRing(done.error());
        return;
    }
    ring.outputsAreBlocked = false;
    zerosAgainAt = {};
    tellOfRing({.id = RingMessageId::watchdogAcknowledged});
}

void RingRunner::Private::waitForLink()
{
    if (ring.at >= reopenAt)
        tryToReopen();
    showStandingWords();
}

// What did arrive of the words of a job that was cut, or of the last words, though a later one was
// acknowledged: an answer may be that to an earlier request.
std::optional<Word> RingRunner::Private::wordLeftThere(std::size_t i) const
{
    const Snapshot::Device &device = ring.devices[i];
    const bool isLeft = device.leftOut || (image[i] != device.out && image[i] == device.outBefore);
    return isLeft && image[i] != 0 ? std::optional(image[i]) : std::nullopt;
}

// That it does not open was reported when it was lost; why may have changed since. A master that was stopped
// meanwhile is not started. Zeros go before anything is asked.
void RingRunner::Private::tryToReopen()
{
    reopenAt = ring.at + betweenOpenings;
    const bool isSent = zerosAreDue && link.sendZerosUnheard();
    auto there = find();
    catchUp();
    if (!there) {
        if (there.error().kind != RefusalKind::stopped)
            ring.whyLost = ofLink(there.error());
        if (isSent)
            tellZerosUnheard();
        return;
    }
    sentUnheard = false;
    ring.connected = true;
    ring.linkBackSince = ring.at;
    ring.whyLost.reset();
    ring.operate = false;
    ring.state = MasterState::active;
    runsAgain = runsAgain && (!master || master->status().state == MasterState::run);
    outIsKnown = there->outIsKnown;
    ring.told.reset();
    tellOfRing({.id = RingMessageId::linkBack});
    forgetDevices();
    ringIsOther = ringIsOther || !isSameRing(there->structure, structure);
    if (ringIsOther) {
        tell(0, *std::move(there));
        return;
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        ring.devices[i].outIsKnown = outIsKnown;
        if (!outIsKnown)
            continue;
        image[i] = goesOn(i, there->out[i]);
        ring.devices[i].leftOut = wordLeftThere(i);
        ring.devices[i].outIsFound = true;
    }
    if (!outIsKnown)
        tellOutIsUnknown();
    comeBack();
}

// Those that went out, or were about to, in the cycle that failed.
void RingRunner::Private::traceUnansweredWords()
{
    for (std::size_t i = 0; i < image.size() && !link.boundsWordsToCycles(); ++i) {
        const Snapshot::Device &device = ring.devices[i];
        if (image[i] != device.out)
            tell(i, Exchange{.cycle = ring.cycle,
                             .at = ring.at,
                             .out = image[i],
                             .in = device.in,
                             .mode = device.reading.mode,
                             .coding = device.reading.coding,
                             .isAnswered = false});
    }
}

// Words by hand that went out, or were about to, in the exchange that failed.
void RingRunner::Private::tellUnheardWords()
{
    for (const std::size_t i : written) {
        if (image[i] == ring.devices[i].out || link.boundsWordsToCycles())
            continue;
        tellOfDevice(
            i, {.severity = Severity::attention, .id = MessageId::outLeft, .arguments = {hexWord(image[i])}});
        ring.devices[i].outIsKnown = false;
        if (image[i] != 0)
            ring.devices[i].leftOut = image[i];
    }
}

// Once.
void RingRunner::Private::tellZerosUnheard()
{
    if (!std::exchange(sentUnheard, true))
        tellOfRing({.severity = Severity::fault, .id = RingMessageId::zerosUnheard});
}

// They were out of sight, and may be others by now.
void RingRunner::Private::forgetDevices()
{
    if (link.isSimulated())
        return;
    for (const auto &driver : drivers)
        if (driver)
            driver->forget();
}

// It is sent once the user says Operate.
void RingRunner::Private::tellOutIsUnknown()
{
    Message message{.severity = Severity::attention};
    message.refusal = Refusal{RefusalKind::notSupported, GatewayRefusalId::outNotReadBack, {}};
    tellOfRing(std::move(message));
}

// There is a ring that can run. An ALARM STOP that came too late for its link goes first.
void RingRunner::Private::comeBack()
{
    seenOfMaster = ~std::uint64_t{0};
    if (zerosAreDue && master)
        carryOut(command::AlarmStop{});
    else if (zerosAreDue)
        zeroOut();
    const bool canRun = !master || master->status().state == MasterState::active ||
                        master->status().state == MasterState::run;
    if (std::exchange(runsAgain, false) && canRun)
        carryOut(command::StartBus{});
}

// Reported whatever the master said about the ring before.
void RingRunner::Private::carryOut(command::UseRing &c)
{
    endJobs(RefusalId::busStopped);
    Drivers before = std::exchange(drivers, {});
    structure = std::move(c.structure);
    image = std::move(c.out);
    for (command::UseRing::Driver &driver : c.drivers) {
        const std::size_t i = drivers.size();
        drivers.push_back(driver.before ? std::move(before[*driver.before]) : std::move(driver.made));
        if (driver.before)
            image[i] = goesOn(i, image[i]);
    }
    received.assign(image.size(), 0);
    written.clear();
    trace = ExchangeTrace(image.size());
    faults = FaultWatch(image.size());
    masterWatch = {};
    ring.devices.assign(image.size(), {});
    tap.forgetDevices();
    for (std::size_t i = 0; i < image.size(); ++i)
        ring.devices[i] = {
            .out = image[i], .reading = {}, .outIsKnown = outIsKnown, .outIsFound = outIsKnown};
    ring.cycle = 0;
    ++ring.generation;
    ringIsOther = false;
    comeBack();
}

Result<void> RingRunner::open(const std::stop_token &stop)
{
    auto found = openUnlessStopped(stop, [this] { return d->find(); });
    d->ring.at = d->link.now();
    d->ring.connected = found.has_value();
    d->outIsKnown = !found || found->outIsKnown;
    Result<void> opened = found ? Result<void>() : tl::unexpected(found.error());
    d->tell(0, LinkOpened{opened});
    if (found) {
        d->ringIsOther = true;
        if (!found->outIsKnown)
            d->tellOutIsUnknown();
        d->tell(0, *std::move(found));
    }
    return opened;
}

} // namespace codewheel
