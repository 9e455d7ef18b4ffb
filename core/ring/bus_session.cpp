// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/hex_code.h"
#include "ring/bus_session_private.h"
#include "ring/send_permission.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace codewheel {

// Without a plan, or with a key that no description has, the make is not known.
const DeviceDescription *BusSession::Private::describe(const Participant &participant) const
{
    const DeviceDescription *named = catalog.find(participant.deviceKey);
    return named ? named : catalog.generic(participant.deviceCode);
}

RingRunner::Drivers BusSession::Private::makeDevices(BusSession &bus)
{
    events.clear();
    {
        // Who is told that one of them ends finds none any more.
        const auto endedSessions = std::exchange(sessions, {});
        const auto endedChannels = std::exchange(channels, {});
    }
    retired.clear();
    retiredChannels.clear();
    otherRing.reset();
    readingIn = false;
    crcHistory.clear();
    descriptions.clear();
    RingRunner::Drivers drivers(structure.size());
    sessions.resize(structure.size());
    renamings.assign(structure.size(), 0);
    for (std::size_t i = 0; i < structure.size(); ++i) {
        const Participant &participant = structure[i];
        channels.push_back(makeChannel(bus, participant));
        drivers[i] = makeSession(bus, i, describe(participant));
    }
    return drivers;
}

std::unique_ptr<WordChannel> BusSession::Private::makeChannel(BusSession &bus, const Participant &participant)
{
    return std::make_unique<WordChannel>(
        bus, bus.placeOf(participant.number), participant.inWords, participant.outWords,
        [&bus](const WordChannel &channel, Word word) { return bus.write(channel, word); });
}

std::unique_ptr<CyclicDriver> BusSession::Private::makeSession(BusSession &bus, std::size_t place,
                                                               const DeviceDescription *description)
{
    sessions[place].reset();
    if (!description)
        return nullptr;
    const DeviceDescription &own = descriptions.emplace_back(*description);
    auto driver = driverFor(own);
    if (driver)
        sessions[place] = std::make_unique<RingEncoderSession>(
            bus, place, bus.placeOf(structure[place].number), own, link->boundsWordsToCycles());
    return driver;
}

Freshness::Circumstances BusSession::Private::circumstances(std::size_t place) const
{
    return {.isConnected = runner != nullptr,
            .isRunning = latest->state == MasterState::run,
            .isInRing = latest->devices[place].inRing,
            .awakeSince = latest->awakeSince,
            .now = latest->at};
}

void BusSession::Private::fetch()
{
    for (RingEvent &event : runner->takeEvents()) {
        if (isStale(event.device) && std::holds_alternative<Event>(event.what)) {
            keepEepromWrites(event);
            continue;
        }
        if (const auto *written = std::get_if<WordWritten>(&event.what))
            channels[event.device]->wasWritten(written->word, event.at);
        else if (std::holds_alternative<DriverTaken>(event.what))
            --renamings[event.device];
        else
            events.push_back(std::move(event));
    }
    if (auto newest = runner->takeLatest()) {
        latest = std::move(newest);
        latestIsNew = true;
    }
}

// Of what was told by the driver from before the device was named.
void BusSession::Private::keepEepromWrites(const RingEvent &event)
{
    const auto *told = std::get_if<Event>(&event.what);
    const auto *change = told ? std::get_if<KnowledgeChanged>(told) : nullptr;
    if (change == nullptr || change->eepromWrites == 0)
        return;
    events.push_back(event);
    events.back().what =
        Event(KnowledgeChanged{.known = {}, .noLongerKnown = {}, .eepromWrites = change->eepromWrites});
}

std::size_t BusSession::Private::indexOf(NodeId node) const
{
    const auto found = std::ranges::find(structure, node, &Participant::number);
    return static_cast<std::size_t>(found - structure.begin());
}

BusSession::BusSession(std::unique_ptr<ProcessDataLink> link, const Catalog &catalog, QDateTime begin,
                       QObject *parent, DriverFactory makeDriver, BusId id)
    : EncoderBus(id, std::move(begin), parent)
    , d(std::make_unique<Private>(*this, std::move(link), catalog, std::move(makeDriver)))
{}

BusSession::~BusSession()
{
    d->thread.reset();
    if (d->runner)
        d->link->close();
}

Result<void> BusSession::open(Start start)
{
    close();
    auto structure = d->link->open();
    if (!structure)
        return tl::unexpected(structure.error());
    auto out = d->link->readBackOut();
    if (!out) {
        d->link->close();
        return tl::unexpected(out.error());
    }
    d->structure = std::move(*structure);
    d->runner = std::make_unique<RingRunner>(*d->link, d->structure, d->makeDevices(*this), *out);
    post(command::AskKeptConfiguration{.onConnecting = true});
    post(command::StartBus{});
    if (start == Start::operating)
        post(command::SetOperate{true});

    // As it will be when the first cycle has carried this out.
    auto expected = std::make_shared<Snapshot>();
    expected->at = d->latest->at;
    expected->state = MasterState::run;
    expected->operate = start == Start::operating;
    for (const Word word : *out)
        expected->devices.push_back({.out = word, .reading = {}});
    if (const MasterLink *master = d->link->master())
        expected->master = std::make_shared<const MasterStatus>(master->status());
    d->latest = std::move(expected);
    showLatest();
    Q_EMIT nodesChanged();
    return {};
}

void BusSession::close()
{
    if (!d->runner)
        return;
    d->thread.reset();
    pump();
    post(command::StopBus{});
    d->runner->cycle(d->latest->at);
    pump();
    d->link->close();
    d->runner.reset();

    auto closed = std::make_shared<Snapshot>(*d->latest);
    closed->state = MasterState::ready;
    closed->operate = false;
    d->latest = std::move(closed);
    showLatest();
}

void BusSession::startThread(std::chrono::nanoseconds period, SleepWatch::Slept slept)
{
    if (d->runner && !d->thread)
        d->thread =
            std::make_unique<PacedThread>(*d->runner, *d->link, period, d->latest->at, std::move(slept));
}

void BusSession::advance(int cycles)
{
    if (!d->runner || d->thread)
        return;
    Instant now = d->latest->at;
    for (int i = 0; i < cycles; ++i)
        d->runner->cycle(now += std::chrono::milliseconds(1));
    pump();
}

void BusSession::advance(Instant duration)
{
    advance(static_cast<int>(duration / std::chrono::milliseconds(1)));
}

// A handler may pump again, start a job or close: what comes of it is told in turn by the outer call.
void BusSession::pump()
{
    if (!d->runner)
        return;
    d->fetch();
    if (d->pumping)
        return;
    d->retired.clear();
    d->retiredChannels.clear();
    const QScopedValueRollback pumping(d->pumping, true);
    while (d->latestIsNew || !d->events.empty()) {
        const bool isNew = std::exchange(d->latestIsNew, false);
        if (isNew)
            showLatest();
        dispatchAll();
        if (isNew)
            Q_EMIT updated();
        if (d->otherRing && d->runner)
            useOtherRing();
    }
}

void BusSession::dispatchAll()
{
    while (!d->events.empty()) {
        const RingEvent event = std::move(d->events.front());
        d->events.pop_front();
        dispatch(event);
    }
}

void BusSession::showLatest()
{
    const auto shown = d->latest;
    if (shown->master)
        d->crcHistory.note(*shown->master, shown->at);
    for (std::size_t i = 0; i < shown->devices.size(); ++i)
        showDevice(i);
    const bool stateIsOther = std::exchange(d->toldState, shown->state) != shown->state;
    const bool operateIsOther = std::exchange(d->toldOperate, shown->operate) != shown->operate;
    if (stateIsOther || operateIsOther)
        Q_EMIT stateChanged();
}

void BusSession::showDevice(std::size_t place)
{
    const auto shown = d->latest;
    const Snapshot::Device &device = shown->devices[place];
    const Freshness::Circumstances circumstances = d->circumstances(place);
    const auto seen = shown->cycle > 0 ? std::optional(device.reading.at) : std::nullopt;
    d->channels[place]->show({device.in, device.out, device.inEdges, device.outEdges, device.heldByJob},
                             {seen, circumstances}, shown->at);
    if (d->sessions[place] && !d->isStale(place))
        d->sessions[place]->show(device.reading, circumstances);
}

void BusSession::dispatch(const RingEvent &event)
{
    RingEncoderSession *session = d->sessions.empty() ? nullptr : d->sessions[event.device].get();
    if (const auto *row = std::get_if<Exchange>(&event.what)) {
        if (session)
            Q_EMIT session->exchanged(*row);
        return;
    }
    if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
        if (session)
            session->take(*ofDriver, event.at);
        return;
    }
    if (const auto *ofMaster = std::get_if<MasterEvent>(&event.what)) {
        takeOfMaster(*ofMaster);
        return;
    }
    if (const auto *slept = std::get_if<Slept>(&event.what)) {
        takeSleep(*slept, event.at);
        return;
    }
    auto message = std::get<Message>(event.what);
    if (message.place)
        message.place->bus = id();
    const bool isFault = session && message.id == MessageId::deviceFault;
    if (isFault)
        message.refusal = session->nameOf(message);
    Q_EMIT messaged(message);
    if (isFault)
        session->takeFault(message);
    else if (message.place && message.refusal)
        Q_EMIT d->channels[event.device]->refused(*message.refusal);
}

// At the place of a channel may be another by now.
Result<void> BusSession::write(const WordChannel &channel, Word word)
{
    const std::size_t device = d->indexOf(channel.place().node);
    if (device >= d->channels.size() || d->channels[device].get() != &channel)
        return refuse(RefusalKind::link, RefusalId::notInRing, {channel.place().toString()});
    const Participant &participant = d->structure[device];
    if (participant.outWords == 0)
        return refuse(RefusalKind::notSupported, RefusalId::sendingNotSupported,
                      {participant.number.toString()});
    const auto &session = d->sessions[device];
    if (auto allowed = maySend(*d->latest, device, participant.number, RefusalId::wordHeldByJob); !allowed)
        return allowed;
    if (session && session->runningJob()) // started, and not shown by a snapshot yet
        return refuse(RefusalKind::busy, RefusalId::wordHeldByJob, {participant.number.toString()});
    if (session)
        Q_EMIT session->wordAboutToBeSent(word);
    post(command::SetOut{device, word});
    return {};
}

Result<void> BusSession::canBe(Place place, const DeviceDescription &device) const
{
    const std::size_t i = d->indexOf(place.node);
    const unsigned there = i < d->structure.size() ? d->structure[i].deviceCode : 0;
    if (device.deviceCode == there)
        return {};
    const QString its = device.profile == Profile::esc ? QStringLiteral("-") : hexCode(device.deviceCode, 4);
    return refuse(RefusalKind::badInput, RefusalId::deviceCodeDiffers,
                  {place.toString(), hexCode(there, 4), device.fullName(), its});
}

Result<void> BusSession::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    const std::size_t i = d->indexOf(place.node);
    if (!d->runner || i >= d->structure.size())
        return refuse(RefusalKind::busy, RefusalId::notRunning, {place.toString()});
    Participant &participant = d->structure[i];
    const DeviceDescription *wanted = d->catalog.find(deviceKey);
    if (wanted)
        if (auto can = canBe(place, *wanted); !can)
            return can;
    if (d->sessions[i] && d->sessions[i]->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.toString()});

    participant.deviceKey = wanted ? deviceKey : QString();
    std::optional<DeviceDescription> described;
    if (const DeviceDescription *found = d->describe(participant))
        described = *found;
    if (described && turns > 0)
        described->physicalTurns = turns;
    if (described && stepsPerTurn > 0)
        described->physicalStepsPerTurn = stepsPerTurn;
    const int writes = d->sessions[i] ? d->sessions[i]->eepromWrites() : 0;
    d->retired.push_back(std::move(d->sessions[i]));
    auto driver = d->makeSession(*this, i, described ? &*described : nullptr);
    if (d->sessions[i])
        d->sessions[i]->countEepromWrites(writes);
    ++d->renamings[i];
    for (const RingEvent &event : std::exchange(d->events, {}))
        if (event.device == i && std::holds_alternative<Event>(event.what))
            d->keepEepromWrites(event);
        else
            d->events.push_back(event);
    post(command::SetDriver{i, std::move(driver), described ? described->fullName() : place.toString()});
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    if (!d->pumping)
        d->retired.clear();
    return {};
}

const Catalog &BusSession::catalog() const
{
    return d->catalog;
}

void BusSession::post(Command command)
{
    if (d->runner)
        d->runner->post(std::move(command));
}

const BusOutline &BusSession::outline() const
{
    return d->outline;
}

bool BusSession::isOpen() const
{
    return d->runner != nullptr;
}

bool BusSession::isSimulated() const
{
    return d->link->isSimulated();
}

const RingStructure &BusSession::structure() const
{
    return d->structure;
}

std::vector<Place> BusSession::places() const
{
    std::vector<Place> places;
    for (const Participant &participant : d->structure)
        places.push_back(placeOf(participant.number));
    return places;
}

EncoderSession *BusSession::encoderAt(NodeId node) const
{
    const std::size_t i = d->indexOf(node);
    return i < d->sessions.size() ? d->sessions[i].get() : nullptr;
}

WordChannel *BusSession::channelAt(NodeId node) const
{
    const std::size_t i = d->indexOf(node);
    return i < d->channels.size() ? d->channels[i].get() : nullptr;
}

const Snapshot &BusSession::latest() const
{
    return *d->latest;
}

bool BusSession::isOperating() const
{
    return d->latest->operate;
}

bool BusSession::isRunning() const
{
    return d->latest->state == MasterState::run;
}

void BusSession::setRunning(bool on)
{
    if (on)
        post(command::StartBus{});
    else
        post(command::StopBus{});
}

void BusSession::setOperate(bool on)
{
    post(command::SetOperate{on});
}

void BusSession::alarmStop()
{
    post(command::AlarmStop{});
}

} // namespace codewheel
