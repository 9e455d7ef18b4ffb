// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_runner_private.h"
#include "kinds/interbus/ring/send_permission.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant longestOutOfSight = std::chrono::seconds(5); // of a device that has a job (assumed)

} // namespace

RingRunner::Private::Private(ProcessDataLink &usedLink, Mail &usedMail)
    : link(usedLink)
    , master(usedLink.master())
    , mail(usedMail)
{
    ring.state = MasterState::active;
}

bool RingRunner::Private::carryOutCommands()
{
    while (!zerosGoNext())
        if (!carryOutNext())
            return true;
    return false;
}

// A gateway keeps the outputs as they are while nothing is exchanged.
bool RingRunner::Private::zerosGoNext() const
{
    return zerosAreDue && ring.connected && !ringIsOther && ring.at >= zerosAgainAt &&
           (ring.state == MasterState::run || !link.boundsWordsToCycles());
}

bool RingRunner::Private::carryOutNext()
{
    auto next = mail.nextCommand();
    if (next)
        std::visit([this](auto &c) { carryOut(c); }, *next);
    return next.has_value();
}

void RingRunner::Private::carryOut(const command::SetOut &c)
{
    if (const auto allowed = mayWrite(c.device, c.word); !allowed) {
        refuseWord(c.device, allowed.error());
        return;
    }
    image[c.device] = c.word;
    link.claimOut(c.device);
    if (std::ranges::find(written, c.device) == written.end())
        written.push_back(c.device);
}

Result<void> RingRunner::Private::mayWrite(std::size_t device, Word word) const
{
    auto allowed = maySend(ring, device, structure[device].number.toString(), RefusalId::wordHeldByJob);
    const CyclicDriver *driver = drivers[device].get();
    if (allowed && driver && !driver->mayStand(word) && !link.boundsWordsToCycles())
        return refuse(RefusalKind::notSupported, RefusalId::linkDoesNotBoundCycles, {word});
    return allowed;
}

void RingRunner::Private::refuseWord(std::size_t device, Refusal why)
{
    Message message{.severity = Severity::attention};
    message.refusal = std::move(why);
    tellOfDevice(device, std::move(message));
}

void RingRunner::Private::carryOut(const command::StartJob &c)
{
    Snapshot::Device &device = ring.devices[c.device];
    CyclicDriver &driver = *drivers[c.device];
    auto taken = maySend(ring, c.device, structure[c.device].number.toString(), RefusalId::jobRunning);
    if (taken)
        taken = driver.begin(c.id, c.job, c.pace, device.in, image[c.device], ring.at);
    device.heldByJob = driver.busy();
    if (taken)
        link.claimOut(c.device);
    else
        tell(c.device, Event(notTaken(c.id, taken.error(), device.reading.state)));
}

// The job may have ended while the command was on its way.
void RingRunner::Private::carryOut(const command::Cancel &c)
{
    if (drivers[c.device]->busy())
        drivers[c.device]->cancel(c.how, ring.at);
}

// What the previous driver showed is no reading of this one.
void RingRunner::Private::carryOut(command::SetDriver &c)
{
    drivers[c.device] = std::move(c.driver);
    ring.devices[c.device].reading = {};
    tell(c.device, DriverTaken{});
    tellOfDevice(c.device, {.id = MessageId::deviceNamed, .arguments = {c.name}});
}

void RingRunner::Private::carryOut(command::StartBus)
{
    if (ring.state == MasterState::run || readingIn || ringIsOther)
        return;
    if (!ring.connected) {
        runsAgain = true;
        reopenAt = ring.at;
        return;
    }
    ring.refusedStart.reset();
    if (const auto started = startTransfer(); !started) {
        if (master && master->status().state == MasterState::ready &&
            started.error().kind == RefusalKind::link)
            ring.refusedStart = started.error();
        refuseOfRing(started.error());
        return;
    }
    if (ringIsOther)
        return;
    ring.state = MasterState::run;
    if (!ringStands()) // otherwise only our exchange runs
        tellOfRing({.id = MessageId::busStarted});
}

void RingRunner::Private::carryOut(command::StopBus)
{
    runsAgain = false;
    if (!ring.connected || ring.state == MasterState::active || (master && ring.state != MasterState::run))
        return;
    if (master)
        if (const auto stopped = master->stopDataTransfer(); !stopped)
            refuseOfRing(stopped.error());
    leaveRun(MasterState::active);
    if (!isClosing || link.boundsWordsToCycles()) // otherwise the ring goes on without us
        tellOfRing({.id = MessageId::busStopped});
}

void RingRunner::Private::carryOut(command::SetOperate c)
{
    if (c.on == ring.operate)
        return;
    const auto held = std::ranges::find(ring.devices, true, &Snapshot::Device::heldByJob);
    if (held != ring.devices.end()) {
        const auto place = structure[static_cast<std::size_t>(held - ring.devices.begin())].number;
        refuseOfRing({RefusalKind::busy, RefusalId::jobRunning, {place.toString()}});
        return;
    }
    if (!c.on)
        takeBackWhatWatchDoesNotSend();
    ring.operate = c.on;
    tellOfRing({.id = c.on ? MessageId::operateOn : MessageId::watchOn});
}

// Words written but not yet exchanged: through a gateway nothing is sent in Watch; elsewhere all but what
// nobody could remove there.
void RingRunner::Private::takeBackWhatWatchDoesNotSend()
{
    if (!link.boundsWordsToCycles()) {
        for (const std::size_t i : written)
            refuseWord(i, {RefusalKind::busy, RefusalId::watchOnly, {structure[i].number.toString()}});
        goOnWithWhatWasExchanged();
        return;
    }
    std::erase_if(written, [this](std::size_t i) {
        const bool mayStand = !drivers[i] || drivers[i]->mayStand(image[i]);
        if (!mayStand)
            image[i] = ring.devices[i].out;
        return !mayStand;
    });
}

void RingRunner::Private::carryOut(command::AlarmStop)
{
    zerosAreDue =
        !ring.connected || !link.boundsWordsToCycles() || (!master && ring.state == MasterState::run);
    if (master && ring.connected) {
        master->alarmStop();
        masterWatch.leftByService();
        ring.refusedStart.reset();
        runsAgain = false;
    }
    ++alarmStops;
    zerosAgainAt = {};
    reopenAt = std::min(reopenAt, ring.at);
    endJobs(RefusalId::alarmStop);
    zeroOut();
    if (!ring.connected || link.boundsWordsToCycles()) // otherwise RingSession::alarmStop() has told
        tellOfRing({.severity = Severity::attention,
                    .id = ring.connected ? RingMessageId::alarmStop : RingMessageId::zerosWait});
    if (readingIn)
        endReadIn(refuse(RefusalKind::stopped, RefusalId::alarmStop));
    lookAtMaster();
}

// Behind a gateway OUT is what it was until the zeros are acknowledged.
void RingRunner::Private::zeroOut()
{
    std::ranges::fill(image, Word{0});
    written.clear();
    if (!link.boundsWordsToCycles())
        for (Snapshot::Device &device : ring.devices)
            device.outIsKnown = false;
}

void RingRunner::Private::work()
{
    if (!ring.connected)
        waitForLink();
    else if (readingIn)
        readInStep();
    else if (ring.state == MasterState::run)
        exchange();
    else if (zerosGoNext())
        zeroAtRest();
    else
        idle();
}

void RingRunner::Private::publish()
{
    ring.droppedRows = mail.droppedRows();
    ring.zerosAreDue = zerosAreDue;
    ring.figures = link.figures();
    for (std::size_t i = 0; i < ring.devices.size(); ++i) {
        const Snapshot::Device &device = ring.devices[i];
        tap.look(i, device.reading, ring.state == MasterState::run && device.inRing, ring.at,
                 ExchangedWords{device.in, device.out});
    }
    mail.note(tap.noted());
    tap.clear();
    mail.publish(ring);
}

void RingRunner::Private::exchange()
{
    const bool sendsZeros = zerosAreDue && ring.at >= zerosAgainAt;
    const bool writes = ring.operate && !zerosAreDue;
    const auto exchanged = sendsZeros ? sendZeros()
                           : writes   ? link.exchange(image, received)
                                      : link.watch(image, received);
    catchUp();
    if (!exchanged) {
        fail(exchanged.error());
        return;
    }
    ++ring.cycle;
    ring.outputsAreBlocked = ring.outputsAreBlocked && !sendsZeros && !writes;
    tellWritten();
    lookWhetherZerosStand();
    lookAtToldRing();
    for (std::size_t i = 0; i < image.size(); ++i)
        step(i);
}

// A gateway takes its time. What is told of it is from when it has answered.
void RingRunner::Private::catchUp()
{
    ring.at = std::max(ring.at, link.now());
}

// A gateway repeats what it has last got, so whether the zeros got there is worth a message.
Result<void> RingRunner::Private::sendZeros()
{
    const auto sent = link.sendZeros(received);
    catchUp();
    if (!sent)
        return tl::unexpected(sent.error());
    zerosAreDue = false;
    zeroOut();
    for (Snapshot::Device &device : ring.devices)
        device.outIsKnown = true;
    if (!link.boundsWordsToCycles())
        tellZeros(*sent);
    if (sent->areThere == true)
        zerosStandUntil = link.now() + std::chrono::seconds(3);
    return {};
}

// They have arrived, and a controller that writes its image in each of its cycles may have written since.
void RingRunner::Private::lookWhetherZerosStand()
{
    if (!zerosStandUntil || zerosAreDue || ring.operate)
        return;
    const QString others = wordsNotZero(link, structure, image);
    if (!others.isEmpty())
        tellZeros({.areThere = false, .notZero = others});
    if (!others.isEmpty() || ring.at >= *zerosStandUntil)
        zerosStandUntil.reset();
}

// As its gateway says.
bool RingRunner::Private::ringStands() const
{
    const auto told = link.toldRing();
    return told && told->stands();
}

void RingRunner::Private::tellZeros(const ProcessDataLink::ZerosSent &zeros)
{
    if (zeros.areThere == false)
        tellOfRing({.severity = Severity::fault,
                    .id = RingMessageId::zerosOverwritten,
                    .arguments = {zeros.notZero}});
    else if (zerosAreBeforeRing = ringStands(); zerosAreBeforeRing)
        tellOfRing({.severity = Severity::fault, .id = RingMessageId::zerosBeforeRing});
    else
        tellOfRing({.id = zeros.areThere ? RingMessageId::zerosReadBack : RingMessageId::zerosSent});
}

// Those that waited for a ring that did not run, unless something else is in OUT by now.
void RingRunner::Private::tellZerosAtDevices()
{
    const bool areThere = std::ranges::all_of(image, [](Word word) { return word == 0; });
    if (std::exchange(zerosAreBeforeRing, false) && areThere)
        tellOfRing({.id = RingMessageId::zerosReadBack});
}

// Only a gateway tells of it. What is on its way to a ring that stands still does not arrive.
void RingRunner::Private::lookAtToldRing()
{
    const bool stood = ring.told && ring.told->stands();
    ring.told = link.toldRing();
    const bool stands = ring.told && ring.told->stands();
    if (stands == stood)
        return;
    if (!stands) {
        tellOfRing({.id = RingMessageId::ringRunsAgain});
        tellZerosAtDevices();
        forgetDevices();
        return;
    }
    endJobs(ring.told->whyItStands());
    refuseOfRing(ring.told->whyItStands());
}

// `stopped` is our own interrupt(): the cycle is skipped, nothing is wrong with the link. Nor is it if the
// master says why nothing can be exchanged.
void RingRunner::Private::fail(const Refusal &why)
{
    const bool masterTellsIt = master && master->status().state != MasterState::run;
    if (why.id == GatewayRefusalId::outNotOurs)
        giveWay(why);
    else if (why.id == GatewayRefusalId::outputsBlocked && zerosAreDue)
        zerosAreBlockedBy(why);
    else if (why.kind != RefusalKind::stopped && !masterTellsIt)
        loseLink(why);
    lookAtMaster();
    showStandingWords();
}

void RingRunner::Private::zeroAtRest()
{
    if (const auto sent = sendZeros(); !sent)
        fail(sent.error());
    showStandingWords();
}

// Somebody else writes to the same outputs. Both would move the machine in turn, so we stop.
void RingRunner::Private::giveWay(const Refusal &why)
{
    endJobs(GatewayRefusalId::outsOfOther);
    goOnWithWhatWasExchanged();
    ring.operate = false;
    refuseOfRing(why);
}

// The gateway answers, but carries out no write until its watchdog is acknowledged: we look on, and they are
// tried again each second.
void RingRunner::Private::zerosAreBlockedBy(const Refusal &why)
{
    ring.operate = false;
    zerosAgainAt = link.now() + std::chrono::seconds(1);
    if (!std::exchange(ring.outputsAreBlocked, true))
        refuseOfRing(why);
}

// One device, after an exchange: its words, its driver's answer, its trace row.
void RingRunner::Private::step(std::size_t i)
{
    Snapshot::Device &device = ring.devices[i];
    const bool isBound = link.boundsWordsToCycles();
    if (!isBound)
        device.inRing = link.isUpToDate(i);
    const Word out = image[i];
    device.outEdges = device.out ^ out;
    device.outIsFound = device.outIsFound && out == device.out;
    if (out != device.out)
        device.outBefore = std::exchange(device.out, out); // a gateway has got it, whatever it says of IN
    device.outIsKnown = device.outIsKnown || (ring.operate && link.writesOut(i));
    if (device.leftOut && device.outIsKnown && out != *device.leftOut)
        device.leftOut.reset();
    CyclicDriver *driver = drivers[i].get();
    const std::optional<Instant> age = !device.inRing ? std::nullopt : isBound ? Instant{} : link.age(i);
    if (!age && driver)
        driver->wait(out);
    if (!device.inRing) {
        endWhatWaitsTooLong(i);
        return;
    }
    const Word in = received[i];
    device.inEdges = ring.cycle == 1 ? 0 : device.in ^ in;
    device.in = in;
    if (!age)
        return;
    device.inIsKnown = true;

    const Instant at = ring.at - *age;
    if (driver) {
        driver->setOthersWrite(!ring.operate);
        const Word next = driver->cycle(in, out, at);
        if (ring.operate) // in Watch nothing changes OUT
            image[i] = next;
        device.reading = driver->reading();
        device.heldByJob = driver->busy();
    } else {
        device.reading.at = at;
        device.reading.in = in;
    }
    if (trace.isRow(i, out, in))
        tell(i, Exchange{ring.cycle, ring.at, out, in, device.reading.mode, device.reading.coding});
    if (auto message = faults.look(i, device.reading))
        tellOfDevice(i, std::move(*message));
    if (driver)
        takeDriverEvents(i);
}

// Its driver waits for words that can be believed.
void RingRunner::Private::endWhatWaitsTooLong(std::size_t i)
{
    if (!ring.devices[i].heldByJob || ring.at - ring.devices[i].reading.at < longestOutOfSight)
        return;
    endJob(i, ring.whyOutOfSight(i, structure[i].number.toString()));
}

void RingRunner::Private::tellWritten()
{
    for (const std::size_t device : written) {
        tell(device, WordWritten{image[device]});
        tellOfDevice(device, {.id = MessageId::wordWritten, .arguments = {image[device]}});
    }
    written.clear();
}

// Without an exchange: OUT as it would go out, IN as it last came in.
void RingRunner::Private::showStandingWords()
{
    for (std::size_t i = 0; i < image.size(); ++i) {
        Snapshot::Device &device = ring.devices[i];
        device.inEdges = 0;
        device.outEdges = device.out ^ image[i];
        device.out = image[i];
    }
}

// OUT stays as last exchanged, so that the same words go out when the bus runs again. A master whose bus has
// failed, or that was not merely stopped, has set the outputs of the devices to 0: then they stay at 0.
void RingRunner::Private::leaveRun(MasterState state, const Refusal &why)
{
    ring.state = state;
    tellOfRing(masterWatch.lookAtRest(ring.at));
    endJobs(why);
    if (master && ring.connected && state != MasterState::active) {
        zeroOut();
        return;
    }
    goOnWithWhatWasExchanged();
}

void RingRunner::Private::goOnWithWhatWasExchanged()
{
    for (std::size_t i = 0; i < image.size(); ++i)
        image[i] = goesOn(i, ring.devices[i].out);
    written.clear();
}

// But not a word that nobody could remove in Watch.
Word RingRunner::Private::goesOn(std::size_t device, Word last) const
{
    return drivers[device] && !drivers[device]->mayStand(last) ? Word{0} : last;
}

void RingRunner::Private::endJobs(const Refusal &why)
{
    for (std::size_t i = 0; i < drivers.size(); ++i) {
        if (!drivers[i])
            continue;
        drivers[i]->leaveStanding(); // before its job tells what it has written
        if (drivers[i]->busy())
            endJob(i, why);
        else if (why.kind == RefusalKind::link)
            drivers[i]->loseSight(image[i]);
        takeDriverEvents(i);
    }
}

void RingRunner::Private::endJob(std::size_t device, const Refusal &why)
{
    drivers[device]->stop(why, ring.at);
    ring.devices[device].heldByJob = drivers[device]->busy();
    takeDriverEvents(device, wordLeftBy(why, device));
}

// A gateway keeps what was written to it last, and nothing more arrives there.
std::optional<Word> RingRunner::Private::wordLeftBy(const Refusal &why, std::size_t device) const
{
    const Word out = ring.devices[device].out;
    return endsOutOfSight(why) && !link.boundsWordsToCycles() && out != 0 ? std::optional(out) : std::nullopt;
}

// `left`: what a job that has ended leaves in OUT besides what it says itself.
void RingRunner::Private::takeDriverEvents(std::size_t device, std::optional<Word> left)
{
    for (Event &event : drivers[device]->takeEvents()) {
        if (auto *outcome = std::get_if<Outcome>(&event)) {
            std::vector<Word> &out = outcome->inDoubt.out;
            if (left && std::ranges::find(out, *left) == out.end())
                out.push_back(*left);
            if (!out.empty()) {
                ring.devices[device].leftOut = out.front();
                ring.devices[device].outIsKnown = ring.devices[device].outIsKnown && ring.connected;
            }
        }
        tell(device, std::move(event));
    }
}

void RingRunner::Private::tellOfRing(Message message)
{
    message.at = ring.at;
    tell(0, std::move(message));
}

void RingRunner::Private::tellOfRing(std::vector<Message> messages)
{
    for (Message &message : messages)
        tellOfRing(std::move(message));
}

void RingRunner::Private::refuseOfRing(const Refusal &why)
{
    const bool isFault = why.kind == RefusalKind::link;
    Message message{.severity = isFault ? Severity::fault : Severity::attention};
    message.refusal = why;
    tellOfRing(std::move(message));
    tell(0, RingRefused{why});
}

void RingRunner::Private::tellOfDevice(std::size_t device, Message message)
{
    message.at = ring.at;
    message.place = Place{.node = structure[device].number};
    tell(device, std::move(message));
}

RingRunner::RingRunner(ProcessDataLink &link)
    : d(std::make_unique<Private>(link, m_mail))
{}

RingRunner::~RingRunner() = default;

// What was posted does not wait until the next cycle is due.
void RingRunner::turn(Instant until)
{
    d->link.wait(until);
    if (d->link.isDue() || m_mail.hasCommands())
        cycle(d->link.now());
}

void RingRunner::cycle(Instant now)
{
    d->ring.at = now;
    if (d->carryOutCommands())
        d->carryOutGuestWords();
    const std::uint64_t before = d->ring.cycle;
    d->work();
    d->lookAtMaster();
    d->showGuests(d->ring.cycle != before);
    d->publish();
}

void RingRunner::slept(std::chrono::milliseconds duration)
{
    d->ring.at = d->link.now();
    d->ring.awakeSince = d->ring.at;
    const std::uint64_t alarmsBefore = d->alarmStops;
    while (d->carryOutNext()) { // posted before
    }
    d->endJobs(RefusalId::computerSlept);
    d->goOnWithWhatWasExchanged();
    if (d->zerosAreDue || d->alarmStops > alarmsBefore) // whatever has been exchanged
        d->zeroOut();
    d->ring.operate = false;
    d->tap.interrupt();
    d->tell(0, Slept{duration});
}

// The zeros of an ALARM STOP go out first.
void RingRunner::close()
{
    d->ring.at = d->link.now();
    d->isClosing = true;
    m_mail.post(command::StopBus{});
    while (!d->carryOutCommands() && d->ring.connected)
        d->work();
    d->isClosing = false;
    d->endJobs(RefusalId::busStopped);
    d->lookAtMaster();
    if (d->guests)
        d->guests->leave();
    d->link.close();
    d->publish();
}

Instant RingRunner::now() const
{
    return d->link.now();
}

void RingRunner::interrupt()
{
    d->link.interrupt();
}

void RingRunner::setPacing(std::chrono::nanoseconds period, std::uint64_t lateCycles)
{
    d->ring.period = period;
    d->ring.lateCycles = lateCycles;
}

bool RingRunner::keepsPace() const
{
    return d->ring.connected;
}

} // namespace codewheel
