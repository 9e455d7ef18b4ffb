// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_session_private.h"
#include "kinds/interbus/ring/ring_strangers.h"
#include "kinds/interbus/ring/send_permission.h"
#include "vocabulary/hex.h"

#include <algorithm>
#include <iterator>

namespace codewheel {
namespace {

constexpr Instant cycleByHand = std::chrono::milliseconds(1);

// By a word that was judged; empty: nothing.
QString wrongBy(const std::optional<DataCheck> &judged)
{
    return judged && judged->outcome == DataCheck::Outcome::differs ? judged->remedy : QString();
}

// There the words of an encoder that does not answer may go to registers of another one.
Event behindGateway(Event event)
{
    if (auto *outcome = std::get_if<Outcome>(&event); outcome && !outcome->result)
        if (Refusal &why = outcome->result.error(); why.id == RefusalId::noAnswer)
            why.id = RefusalId::noAnswerAtGateway;
    return event;
}

// The word of the message that OUT may hold it.
QString sentIn(const Message &message)
{
    const auto *word = message.arguments.empty() ? nullptr : std::get_if<QString>(&message.arguments.front());
    return word != nullptr ? *word : QString();
}

bool isAboutZeros(MessageCode id)
{
    return id == RingMessageId::zerosReadBack || id == RingMessageId::zerosOverwritten ||
           id == RingMessageId::zerosSent || id == RingMessageId::zerosWait ||
           id == RingMessageId::zerosBeforeRing;
}

} // namespace

command::UseRing RingSession::Private::makeDevices(RingSession &bus, const RingFound &found)
{
    forgetDevices();
    structure = found.structure;
    sessions.resize(structure.size());
    renamings.assign(structure.size(), 0);
    command::UseRing use{structure, found.out, {}};
    for (std::size_t i = 0; i < structure.size(); ++i) {
        const RingDevice &participant = structure[i];
        channels.push_back(makeChannel(bus, participant));
        use.drivers.push_back(
            {makeSession(bus, i, catalog.find(participant.deviceKey, participant.deviceCode)), {}});
    }
    return use;
}

std::unique_ptr<WordChannel> RingSession::Private::makeChannel(RingSession &bus,
                                                               const RingDevice &participant)
{
    return std::make_unique<WordChannel>(
        bus, bus.placeOf(participant.number), participant.inWords, participant.outWords,
        [&bus](const WordChannel &channel, Word word) { return bus.write(channel, word); });
}

std::unique_ptr<CyclicDriver> RingSession::Private::makeSession(RingSession &bus, std::size_t place,
                                                                const DeviceDescription *description)
{
    sessions[place].reset();
    if (!description)
        return nullptr;
    const DeviceDescription &own = descriptions.emplace_back(*description);
    auto driver = driverFor(own);
    if (driver && !link->boundsWordsToCycles())
        driver->expectTornWords();
    if (driver)
        sessions[place] = std::make_unique<RingEncoderSession>(
            bus, place, bus.placeOf(structure[place].number), own, link->boundsWordsToCycles());
    return driver;
}

// Those reported by the previous driver, from before the device was named.
void RingSession::Private::keepEepromWrites(const RingEvent &event)
{
    const auto *told = std::get_if<Event>(&event.what);
    const auto *change = told ? std::get_if<KnowledgeChanged>(told) : nullptr;
    if (change == nullptr || change->eepromWrites == 0)
        return;
    engine.waiting().push_back(event);
    engine.waiting().back().what =
        Event(KnowledgeChanged{.known = {}, .noLongerKnown = {}, .eepromWrites = change->eepromWrites});
}

// As last seen, also in an exchange that was given up because of it.
std::vector<Word> RingSession::Private::outNow() const
{
    const Snapshot &shown = latest();
    std::vector<Word> out(shown.devices.size());
    std::ranges::transform(shown.devices, out.begin(), &Snapshot::Device::out);
    for (const auto &[device, its] : foreign)
        if (device < out.size() && shown.cycle <= its.cycle)
            out[device] = its.word;
    return out;
}

void RingSession::Private::noteForeign(const Refusal &why)
{
    if (why.id != GatewayRefusalId::outNotOurs)
        return;
    const auto device = indexOf(NodeId(std::get<QString>(why.arguments[0]).toStdString()));
    const Word word = std::get<Word>(why.arguments[2]);
    foreign[device] = {.word = word, .cycle = latest().cycle};
    if (zerosAskedAt && device < outBeforeZeros.size())
        outBeforeZeros[device] = word;
}

std::size_t RingSession::Private::indexOf(NodeId node) const
{
    const auto found = std::ranges::find(structure, node, &RingDevice::number);
    return static_cast<std::size_t>(found - structure.begin());
}

RingSession::RingSession(std::unique_ptr<ProcessDataLink> link, const Catalog &catalog, QDateTime begin,
                         QObject *parent, DriverFactory makeDriver, BusId id)
    : EncoderBus(id, std::move(begin), ringTrafficColumns, parent)
    , d(std::make_unique<Private>(*this, std::move(link), catalog, std::move(makeDriver)))
{}

RingSession::~RingSession() = default;

Result<void> RingSession::open(Start start, std::optional<Pacing> pacing)
{
    close();
    d->start = start;
    d->generation = 0;
    d->readingIn = false;
    d->stoppedBy = StoppedBy::other;
    d->crcHistory.clear();
    auto runner = std::make_unique<RingRunner>(*d->link);
    runner->post(command::OfferTo{d->guests});
    return d->engine.open(std::move(runner), std::move(pacing));
}

void RingSession::offerTo(std::shared_ptr<RingGuests> guests)
{
    d->guests = std::move(guests);
    post(command::OfferTo{d->guests});
}

std::unique_ptr<ProcessDataLink> RingSession::useLink(std::unique_ptr<ProcessDataLink> link,
                                                      const QDateTime &time)
{
    close(); // an open that was refused leaves its runner behind
    const QDateTime last = dateTime(now());
    auto nothing = std::make_shared<Snapshot>();
    nothing->at = link->now();
    setClock(std::max(last, time), nothing->at);
    d->forgetDevices();
    d->engine.setLatest(std::move(nothing));
    auto before = std::exchange(d->link, std::move(link));
    showLatest();
    Q_EMIT nodesChanged();
    return before;
}

bool RingSession::areZerosBeforeRing() const
{
    return d->zerosAreBeforeRing;
}

QString RingSession::outBeforeZeros() const
{
    const QString texts = wordsNotZero(*d->link, d->structure, d->outBeforeZeros);
    return texts.isEmpty() ? hexWord(0) : texts;
}

bool RingSession::sendZerosUnheard()
{
    return !isOpen() && d->link->sendZerosUnheard();
}

bool RingSession::waitsForZeros() const
{
    return isOpen() && (d->zerosAskedAt || d->latest().zerosAreDue);
}

void RingSession::close()
{
    if (!d->engine.close())
        return;
    if (d->zerosAskedAt || d->latest().zerosAreDue)
        tell({.at = d->latest().at, .severity = Severity::fault, .id = RingMessageId::zerosGivenUp});
    d->zerosAskedAt.reset();
    d->zerosAreLate = false;
    d->zerosAreBeforeRing = false;
    d->toBringBack.reset();
    auto closed = std::make_shared<Snapshot>(d->latest());
    closed->state = MasterState::ready;
    closed->operate = false;
    d->engine.setLatest(std::move(closed));
    showLatest();
}

void RingSession::startThread(std::chrono::nanoseconds period, SleepWatch::Slept slept)
{
    d->engine.startThread({period, std::move(slept)});
}

void RingSession::advance(int cycles)
{
    advance(cycles * cycleByHand);
}

void RingSession::advance(Instant duration)
{
    d->endRetired();
    d->engine.advance(duration, cycleByHand);
}

void RingSession::pump()
{
    d->endRetired();
    d->engine.pump();
    lookForZeros();
}

// The bus thread may hang in a transaction meanwhile.
void RingSession::lookForZeros()
{
    constexpr Instant patience = std::chrono::seconds(1);
    if (!d->zerosAskedAt || d->zerosAreLate || d->link->now() - *d->zerosAskedAt < patience)
        return;
    d->zerosAreLate = true;
    tell({.at = d->link->now(),
          .severity = Severity::fault,
          .id = RingMessageId::zerosLate,
          .arguments = {outBeforeZeros()}});
    Q_EMIT updated();
}

bool RingSession::areZerosLate() const
{
    return d->zerosAreLate;
}

// Whoever is told that one of them ends no longer finds any. One of them may be emitting right now.
void RingSession::Private::retireAll()
{
    std::ranges::move(std::exchange(sessions, {}), std::back_inserter(retired));
    std::ranges::move(std::exchange(channels, {}), std::back_inserter(retiredChannels));
    retiredDescriptions.push_back(std::exchange(descriptions, {}));
}

void RingSession::Private::forgetDevices()
{
    retireAll();
    endRetired();
    structure.clear();
    foreign.clear();
    renamings.clear();
}

void RingSession::Private::endRetired()
{
    if (engine.isPumping())
        return;
    retired.clear();
    retiredChannels.clear();
    retiredDescriptions.clear();
}

// What shows in the very next frame.
bool RingSession::takeAtOnce(const RingEvent &event)
{
    const bool isOfRing = event.generation == d->generation;
    if (const auto *written = std::get_if<WordWritten>(&event.what)) {
        if (isOfRing)
            d->channels[event.device]->wasWritten(written->word, event.at);
        return true;
    }
    if (std::holds_alternative<DriverTaken>(event.what)) {
        if (isOfRing)
            --d->renamings[event.device];
        return true;
    }
    if (!isOfRing || !std::holds_alternative<Event>(event.what) || !d->isStale(event.device))
        return false;
    d->keepEepromWrites(event);
    return true;
}

bool RingSession::isOfNow(const Snapshot &snapshot) const
{
    return snapshot.generation == d->generation && d->generation > 0;
}

EncoderSession *RingSession::showing(std::size_t device) const
{
    return device < d->sessions.size() && !d->isStale(device) ? d->sessions[device].get() : nullptr;
}

void RingSession::showLatest()
{
    const auto shown = d->engine.latest();
    if (shown->master)
        d->crcHistory.note(*shown->master, shown->at);
    d->doubts.look(
        *shown,
        [this](std::size_t place) {
            const auto &session = d->sessions[place];
            return session ? std::optional(session->device().profile) : std::nullopt;
        },
        [this](std::size_t place) { return wrongBy(checkWord(place)); });
    for (std::size_t i = 0; i < shown->devices.size(); ++i)
        showDevice(i);
    goOnBringingBack();
    const MasterState before = std::exchange(d->toldState, shown->state);
    if (before == MasterState::run && shown->state == MasterState::busFail)
        d->stoppedBy = StoppedBy::fault;
    tellState(before != shown->state);
}

void RingSession::showDevice(std::size_t place)
{
    const auto shown = d->engine.latest();
    const Snapshot::Device &device = shown->devices[place];
    const bool isSeenAgain = !isRunning() || device.reading.at >= shown->linkBackSince;
    const Freshness::Circumstances circumstances{.isConnected = isOpen(),
                                                 .isLinkThere = shown->connected && isSeenAgain,
                                                 .isRunning = isRunning(),
                                                 .isOnBus = device.inRing || shown->isUnsettled(place),
                                                 .isSettled = !shown->isUnsettled(place),
                                                 .awakeSince = shown->awakeSince,
                                                 .now = shown->at};
    const bool isInKnown = device.inIsKnown || !shown->isUnsettled(place);
    const auto seen = shown->cycle > 0 && isInKnown ? std::optional(device.reading.at) : std::nullopt;
    d->channels[place]->show({.in = device.in,
                              .out = device.out,
                              .inEdges = device.inEdges,
                              .outEdges = device.outEdges,
                              .heldByJob = device.heldByJob,
                              .outIsKnown = device.outIsKnown,
                              .inIsKnown = isInKnown},
                             {seen, circumstances}, shown->at);
    if (d->sessions[place] && !d->isStale(place))
        d->sessions[place]->show(device.reading, circumstances);
}

// For an earlier ring, the end of each job has already been reported.
void RingSession::dispatch(const RingEvent &event)
{
    const bool isOfRing = event.generation == d->generation && event.device < d->sessions.size();
    RingEncoderSession *session = isOfRing ? d->sessions[event.device].get() : nullptr;
    if (const auto *row = std::get_if<Exchange>(&event.what)) {
        if (session) {
            Q_EMIT session->exchanged(*row);
            tellTraffic(session->m_traffic.row(session->place(), *row));
        }
    } else if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
        if (session)
            session->take(d->latest().figures ? behindGateway(*ofDriver) : *ofDriver, event.at);
    } else if (const auto *ofGuest = std::get_if<GuestWrote>(&event.what)) {
        if (session)
            Q_EMIT session->wordAboutToBeSent(ofGuest->word);
    } else if (const auto *ofMaster = std::get_if<MasterEvent>(&event.what)) {
        takeOfMaster(*ofMaster);
    } else if (const auto *slept = std::get_if<Slept>(&event.what)) {
        takeSleep(*slept, event.at);
    } else if (const auto *found = std::get_if<RingFound>(&event.what)) {
        if (isOpen())
            useOtherRing(*found);
        else if (d->engine.state() == BusState::open)
            useFirstRing(*found);
    } else if (const auto *refusal = std::get_if<RingRefused>(&event.what)) {
        d->toBringBack.reset(); // it would come as a surprise later
        d->noteForeign(refusal->why);
        Q_EMIT refused(refusal->why);
    } else if (const auto *message = std::get_if<Message>(&event.what)) {
        dispatch(*message, isOfRing ? std::optional(event.device) : std::nullopt);
    }
}

bool RingSession::isWordDoubtful(std::size_t device) const
{
    return !wrongBy(checkWord(device)).isEmpty() || !d->doubts.wrongWord(device).isEmpty();
}

void RingSession::dispatch(Message message, std::optional<std::size_t> device)
{
    RingEncoderSession *session = device ? d->sessions[*device].get() : nullptr;
    const bool isFault = session && message.id == MessageId::deviceFault;
    if (isFault && isWordDoubtful(*device))
        return; // an error in a word that the encoder cannot have sent is none
    if (isFault)
        message.refusal = session->nameOf(message);
    if (isAboutZeros(message.id)) {
        d->zerosAskedAt.reset();
        d->zerosAreLate = false;
    }
    if (message.id == RingMessageId::zerosBeforeRing || message.id == RingMessageId::ringRunsAgain)
        d->zerosAreBeforeRing = message.id == RingMessageId::zerosBeforeRing;
    if (message.id == MessageId::outLeft && device) // by hand: it is not to be sent again
        if (WordChannel &channel = *d->channels[*device]; hexWord(channel.shownOut()) == sentIn(message))
            channel.unstage();
    tell(message);
    const bool wasOutOfSight =
        message.id == RingMessageId::linkBack || message.id == RingMessageId::ringRunsAgain;
    if (wasOutOfSight && !isSimulated())
        meetAgain();
    if (isFault)
        session->takeFault(message);
    else if (device && message.place && message.refusal)
        Q_EMIT d->channels[*device]->refused(*message.refusal);
}

// While the link was lost an encoder may have been exchanged, or set up by somebody else.
void RingSession::meetAgain()
{
    Q_EMIT meetsAgain();
    for (const auto &session : d->sessions)
        if (session)
            session->meetAgain();
}

// By now another device may be at the place of a channel.
Result<void> RingSession::write(const WordChannel &channel, Word word)
{
    const std::size_t device = d->indexOf(channel.place().node);
    if (device >= d->channels.size() || d->channels[device].get() != &channel)
        return refuse(RefusalKind::link, RingRefusalId::notInRing, {channel.place().shown()});
    const RingDevice &participant = d->structure[device];
    if (participant.outWords == 0)
        return refuse(RefusalKind::notSupported, RefusalId::sendingNotSupported, {channel.place().shown()});
    const auto &session = d->sessions[device];
    if (auto allowed = maySend(d->latest(), device, channel.place().shown(), RefusalId::wordHeldByJob);
        !allowed)
        return allowed;
    if (session && session->runningJob()) // started, but not yet shown by a snapshot
        return refuse(RefusalKind::busy, RefusalId::wordHeldByJob, {channel.place().shown()});
    if (session)
        Q_EMIT session->wordAboutToBeSent(word);
    post(command::SetOut{device, word});
    return {};
}

Result<void> RingSession::canBe(Place place, const DeviceDescription &device) const
{
    const std::size_t i = d->indexOf(place.node);
    const unsigned there = i < d->structure.size() ? d->structure[i].deviceCode : 0;
    if (device.deviceCode == 0)
        return refuse(RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), device.fullName()});
    if (device.deviceCode == there)
        return {};
    return refuse(RefusalKind::badInput, RingRefusalId::deviceCodeDiffers,
                  {place.shown(), hexCode(there, 4), device.fullName(), hexCode(device.deviceCode, 4)});
}

Result<void> RingSession::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    const std::size_t i = d->indexOf(place.node);
    if (!isOpen() || i >= d->structure.size())
        return refuse(RefusalKind::busy, RefusalId::notRunning, {place.shown()});
    RingDevice &participant = d->structure[i];
    const DeviceDescription *wanted = d->catalog.find(deviceKey);
    if (auto may = mayName(place, wanted); !may)
        return may;

    participant.deviceKey = wanted ? deviceKey : QString();
    std::optional<DeviceDescription> described;
    if (const auto *found = d->catalog.find(participant.deviceKey, participant.deviceCode))
        described = found->labelled(turns, stepsPerTurn);
    const int writes = d->sessions[i] ? d->sessions[i]->eepromWrites() : 0;
    d->retired.push_back(std::move(d->sessions[i]));
    auto driver = d->makeSession(*this, i, described ? &*described : nullptr);
    if (d->sessions[i])
        d->sessions[i]->countEepromWrites(writes);
    ++d->renamings[i];
    for (const RingEvent &event : std::exchange(d->engine.waiting(), {}))
        if (event.device == i && std::holds_alternative<Event>(event.what))
            d->keepEepromWrites(event);
        else
            d->engine.waiting().push_back(event);
    post(command::SetDriver{i, std::move(driver), described ? described->fullName() : place.toString()});
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    d->endRetired();
    return {};
}

const Catalog &RingSession::catalog() const
{
    return d->catalog;
}

void RingSession::post(Command command)
{
    d->engine.post(std::move(command));
}

const BusOutline &RingSession::outline() const
{
    return d->outline;
}

DataChecks RingSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return ringChecks(*this, d->stoppedBy, node, planned);
}

// Not open before its devices are known.
BusState RingSession::state() const
{
    if (d->engine.state() != BusState::open)
        return d->engine.state();
    if (d->generation == 0)
        return BusState::opening;
    return d->latest().connected ? BusState::open : BusState::lost;
}

bool RingSession::findsDevices() const
{
    return d->link->findsDevices();
}

bool RingSession::isSimulated() const
{
    return d->link->isSimulated();
}

const RingStructure &RingSession::structure() const
{
    return d->structure;
}

std::optional<Participant> RingSession::found(Place place) const
{
    const auto there = std::ranges::find(d->structure, place.node, &RingDevice::number);
    return place.bus == id() && there != d->structure.end() ? std::optional<Participant>(*there)
                                                            : std::nullopt;
}

QString RingSession::nameOf(const Participant &device, const DeviceDescription *description) const
{
    return nameOrTerminal(ringDevice(device), description);
}

Refusal RingSession::whyNotThere(Place place) const
{
    return {RefusalKind::link, RingRefusalId::notInRing, {place.shown()}};
}

std::map<NodeId, Refusal> RingSession::strangers(const std::vector<Participant> &planned) const
{
    return strangersInRing(ringStructure(planned), d->structure, d->catalog);
}

std::vector<Place> RingSession::places() const
{
    std::vector<Place> places;
    for (const RingDevice &participant : d->structure)
        places.push_back(placeOf(participant.number));
    return places;
}

EncoderSession *RingSession::encoderAt(NodeId node) const
{
    const std::size_t i = d->indexOf(node);
    return i < d->sessions.size() ? d->sessions[i].get() : nullptr;
}

WordChannel *RingSession::channelAt(NodeId node) const
{
    const std::size_t i = d->indexOf(node);
    return i < d->channels.size() ? d->channels[i].get() : nullptr;
}

const Snapshot &RingSession::latest() const
{
    return d->latest();
}

bool RingSession::isOperating() const
{
    return d->latest().operate;
}

bool RingSession::isRunning() const
{
    return d->latest().state == MasterState::run;
}

void RingSession::setRunning(bool on)
{
    d->stoppedBy = on ? StoppedBy::other : StoppedBy::program;
    if (on)
        post(command::StartBus{});
    else
        post(command::StopBus{});
}

void RingSession::setOperate(bool on)
{
    post(command::SetOperate{on});
}

void RingSession::alarmStop()
{
    d->stoppedBy = StoppedBy::alarmStop;
    const bool isGateway = isOpen() && !d->link->boundsWordsToCycles();
    if (isGateway && !d->zerosAskedAt) {
        d->zerosAskedAt = d->link->now();
        d->outBeforeZeros = d->outNow();
    }
    if (isGateway && d->latest().connected) // at once: the bus thread may hang in a transaction
        tell({.at = d->link->now(), .severity = Severity::attention, .id = RingMessageId::zerosAsked});
    if (isGateway)
        d->link->hurryToZeros();
    post(command::AlarmStop{});
}

} // namespace codewheel
