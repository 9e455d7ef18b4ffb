// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_session.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_encoder_session.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
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

command::UseRing RingSession::makeDevices(const RingFound &found)
{
    forgetDevices();
    m_structure = found.structure;
    m_sessions.resize(m_structure.size());
    m_renamings.assign(m_structure.size(), 0);
    command::UseRing use{m_structure, found.out, {}};
    for (std::size_t i = 0; i < m_structure.size(); ++i) {
        const RingDevice &participant = m_structure[i];
        m_channels.push_back(makeChannel(participant));
        use.drivers.push_back(
            {makeSession(i, m_catalog.find(participant.deviceKey, participant.deviceCode)), {}});
    }
    return use;
}

std::unique_ptr<WordChannel> RingSession::makeChannel(const RingDevice &participant)
{
    return std::make_unique<WordChannel>(
        *this, placeOf(participant.number), participant.inWords, participant.outWords,
        [this](const WordChannel &channel, Word word) { return write(channel, word); });
}

std::unique_ptr<CyclicDriver> RingSession::makeSession(std::size_t place,
                                                       const DeviceDescription *description)
{
    m_sessions[place].reset();
    if (!description)
        return nullptr;
    const DeviceDescription &own = m_descriptions.emplace_back(*description);
    auto driver = m_driverFor(own);
    if (driver && !m_link->boundsWordsToCycles())
        driver->expectTornWords();
    if (driver)
        m_sessions[place] = std::make_unique<RingEncoderSession>(
            *this, place, placeOf(m_structure[place].number), own, m_link->boundsWordsToCycles());
    return driver;
}

// Those reported by the previous driver, from before the device was named.
void RingSession::keepEepromWrites(const RingEvent &event)
{
    const auto *told = std::get_if<Event>(&event.what);
    const auto *change = told ? std::get_if<KnowledgeChanged>(told) : nullptr;
    if (change == nullptr || change->eepromWrites == 0)
        return;
    m_engine.waiting().push_back(event);
    m_engine.waiting().back().what =
        Event(KnowledgeChanged{.known = {}, .noLongerKnown = {}, .eepromWrites = change->eepromWrites});
}

// As last seen, also in an exchange that was given up because of it.
std::vector<Word> RingSession::outNow() const
{
    const Snapshot &shown = latest();
    std::vector<Word> out(shown.devices.size());
    std::ranges::transform(shown.devices, out.begin(), &Snapshot::Device::out);
    for (const auto &[device, its] : m_foreign)
        if (device < out.size() && shown.cycle <= its.cycle)
            out[device] = its.word;
    return out;
}

void RingSession::noteForeign(const Refusal &why)
{
    if (why.id != GatewayRefusalId::outNotOurs)
        return;
    const auto device = indexOf(NodeId(std::get<QString>(why.arguments[0]).toStdString()));
    const Word word = std::get<Word>(why.arguments[2]);
    m_foreign[device] = {.word = word, .cycle = latest().cycle};
    if (m_zerosAskedAt && device < m_outBeforeZeros.size())
        m_outBeforeZeros[device] = word;
}

std::size_t RingSession::indexOf(NodeId node) const
{
    const auto found = std::ranges::find(m_structure, node, &RingDevice::number);
    return static_cast<std::size_t>(found - m_structure.begin());
}

RingSession::RingSession(std::unique_ptr<ProcessDataLink> link, const Catalog &catalog, QDateTime begin,
                         QObject *parent, DriverFactory makeDriver, BusId id)
    : EncoderBus(id, std::move(begin), ringTrafficColumns, parent)
    , m_outline(*this)
    , m_link(std::move(link))
    , m_catalog(catalog)
    , m_driverFor(makeDriver ? std::move(makeDriver) : DriverFactory(codewheel::makeDriver))
    , m_engine(*this)
{}

RingSession::~RingSession() = default;

Result<void> RingSession::open(Start start, std::optional<Pacing> pacing)
{
    close();
    m_start = start;
    m_generation = 0;
    m_readingIn = false;
    m_stoppedBy = StoppedBy::other;
    m_crcHistory.clear();
    auto runner = std::make_unique<RingRunner>(*m_link);
    runner->post(command::OfferTo{m_guests});
    return m_engine.open(std::move(runner), std::move(pacing));
}

void RingSession::offerTo(std::shared_ptr<RingGuests> guests)
{
    m_guests = std::move(guests);
    post(command::OfferTo{m_guests});
}

std::unique_ptr<ProcessDataLink> RingSession::useLink(std::unique_ptr<ProcessDataLink> link,
                                                      const QDateTime &time)
{
    close(); // an open that was refused leaves its runner behind
    const QDateTime last = dateTime(now());
    auto nothing = std::make_shared<Snapshot>();
    nothing->at = link->now();
    setClock(std::max(last, time), nothing->at);
    forgetDevices();
    m_engine.setLatest(std::move(nothing));
    auto before = std::exchange(m_link, std::move(link));
    showLatest();
    Q_EMIT nodesChanged();
    return before;
}

QString RingSession::outBeforeZeros() const
{
    const QString texts = wordsNotZero(*m_link, m_structure, m_outBeforeZeros);
    return texts.isEmpty() ? hexWord(0) : texts;
}

void RingSession::close()
{
    if (!m_engine.close())
        return;
    if (m_zerosAskedAt || latest().zerosAreDue)
        tell({.at = latest().at, .severity = Severity::fault, .id = RingMessageId::zerosGivenUp});
    m_zerosAskedAt.reset();
    m_zerosAreLate = false;
    m_zerosAreBeforeRing = false;
    m_toBringBack.reset();
    auto closed = std::make_shared<Snapshot>(latest());
    closed->state = MasterState::ready;
    closed->operate = false;
    m_engine.setLatest(std::move(closed));
    showLatest();
}

void RingSession::advance(int cycles)
{
    advance(cycles * cycleByHand);
}

void RingSession::advance(Instant duration)
{
    endRetired();
    m_engine.advance(duration, cycleByHand);
}

void RingSession::pump()
{
    endRetired();
    m_engine.pump();
    lookForZeros();
}

// The bus thread may hang in a transaction meanwhile.
void RingSession::lookForZeros()
{
    constexpr Instant patience = std::chrono::seconds(1);
    if (!m_zerosAskedAt || m_zerosAreLate || m_link->now() - *m_zerosAskedAt < patience)
        return;
    m_zerosAreLate = true;
    tell({.at = m_link->now(),
          .severity = Severity::fault,
          .id = RingMessageId::zerosLate,
          .arguments = {outBeforeZeros()}});
    Q_EMIT updated();
}

// Whoever is told that one of them ends no longer finds any. One of them may be emitting right now.
void RingSession::retireAll()
{
    std::ranges::move(std::exchange(m_sessions, {}), std::back_inserter(m_retired));
    std::ranges::move(std::exchange(m_channels, {}), std::back_inserter(m_retiredChannels));
    m_retiredDescriptions.push_back(std::exchange(m_descriptions, {}));
}

void RingSession::forgetDevices()
{
    retireAll();
    endRetired();
    m_structure.clear();
    m_foreign.clear();
    m_renamings.clear();
}

void RingSession::endRetired()
{
    if (m_engine.isPumping())
        return;
    m_retired.clear();
    m_retiredChannels.clear();
    m_retiredDescriptions.clear();
}

// What shows in the very next frame.
bool RingSession::takeAtOnce(const RingEvent &event)
{
    const bool isOfRing = event.generation == m_generation;
    if (const auto *written = std::get_if<WordWritten>(&event.what)) {
        if (isOfRing)
            m_channels[event.device]->wasWritten(written->word, event.at);
        return true;
    }
    if (std::holds_alternative<DriverTaken>(event.what)) {
        if (isOfRing)
            --m_renamings[event.device];
        return true;
    }
    if (!isOfRing || !std::holds_alternative<Event>(event.what) || !isStale(event.device))
        return false;
    keepEepromWrites(event);
    return true;
}

EncoderSession *RingSession::showing(std::size_t device) const
{
    return device < m_sessions.size() && !isStale(device) ? m_sessions[device].get() : nullptr;
}

void RingSession::showLatest()
{
    const auto shown = m_engine.latest();
    if (shown->master)
        m_crcHistory.note(*shown->master, shown->at);
    m_doubts.look(
        *shown,
        [this](std::size_t place) {
            const auto &session = m_sessions[place];
            return session ? std::optional(session->device().profile) : std::nullopt;
        },
        [this](std::size_t place) { return wrongBy(checkWord(place)); });
    for (std::size_t i = 0; i < shown->devices.size(); ++i)
        showDevice(i);
    goOnBringingBack();
    const MasterState before = std::exchange(m_toldState, shown->state);
    if (before == MasterState::run && shown->state == MasterState::busFail)
        m_stoppedBy = StoppedBy::fault;
    tellState(before != shown->state);
}

void RingSession::showDevice(std::size_t place)
{
    const auto shown = m_engine.latest();
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
    m_channels[place]->show({.in = device.in,
                             .out = device.out,
                             .inEdges = device.inEdges,
                             .outEdges = device.outEdges,
                             .heldByJob = device.heldByJob,
                             .outIsKnown = device.outIsKnown,
                             .inIsKnown = isInKnown},
                            {seen, circumstances}, shown->at);
    if (m_sessions[place] && !isStale(place))
        m_sessions[place]->show(device.reading, circumstances);
}

// For an earlier ring, the end of each job has already been reported.
void RingSession::dispatch(const RingEvent &event)
{
    const bool isOfRing = event.generation == m_generation && event.device < m_sessions.size();
    RingEncoderSession *session = isOfRing ? m_sessions[event.device].get() : nullptr;
    if (const auto *row = std::get_if<Exchange>(&event.what)) {
        if (session) {
            Q_EMIT session->exchanged(*row);
            tellTraffic(session->m_traffic.row(session->place(), *row));
        }
    } else if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
        if (session)
            session->take(latest().figures ? behindGateway(*ofDriver) : *ofDriver, event.at);
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
        else if (m_engine.state() == BusState::open)
            useFirstRing(*found);
    } else if (const auto *refusal = std::get_if<RingRefused>(&event.what)) {
        m_toBringBack.reset(); // it would come as a surprise later
        noteForeign(refusal->why);
        Q_EMIT refused(refusal->why);
    } else if (const auto *message = std::get_if<Message>(&event.what)) {
        dispatch(*message, isOfRing ? std::optional(event.device) : std::nullopt);
    }
}

bool RingSession::isWordDoubtful(std::size_t device) const
{
    return !wrongBy(checkWord(device)).isEmpty() || !m_doubts.wrongWord(device).isEmpty();
}

void RingSession::dispatch(Message message, std::optional<std::size_t> device)
{
    RingEncoderSession *session = device ? m_sessions[*device].get() : nullptr;
    const bool isFault = session && message.id == MessageId::deviceFault;
    if (isFault && isWordDoubtful(*device))
        return; // an error in a word that the encoder cannot have sent is none
    if (isFault)
        message.refusal = session->nameOf(message);
    if (isAboutZeros(message.id)) {
        m_zerosAskedAt.reset();
        m_zerosAreLate = false;
    }
    if (message.id == RingMessageId::zerosBeforeRing || message.id == RingMessageId::ringRunsAgain)
        m_zerosAreBeforeRing = message.id == RingMessageId::zerosBeforeRing;
    if (message.id == MessageId::outLeft && device) // by hand: it is not to be sent again
        if (WordChannel &channel = *m_channels[*device]; hexWord(channel.shownOut()) == sentIn(message))
            channel.unstage();
    tell(message);
    const bool wasOutOfSight =
        message.id == RingMessageId::linkBack || message.id == RingMessageId::ringRunsAgain;
    if (wasOutOfSight && !isSimulated())
        meetAgain();
    if (isFault)
        session->takeFault(message);
    else if (device && message.place && message.refusal)
        Q_EMIT m_channels[*device]->refused(*message.refusal);
}

// While the link was lost an encoder may have been exchanged, or set up by somebody else.
void RingSession::meetAgain()
{
    Q_EMIT meetsAgain();
    for (const auto &session : m_sessions)
        if (session)
            session->meetAgain();
}

// By now another device may be at the place of a channel.
Result<void> RingSession::write(const WordChannel &channel, Word word)
{
    const std::size_t device = indexOf(channel.place().node);
    if (device >= m_channels.size() || m_channels[device].get() != &channel)
        return refuse(RefusalKind::link, RingRefusalId::notInRing, {channel.place().shown()});
    const RingDevice &participant = m_structure[device];
    if (participant.outWords == 0)
        return refuse(RefusalKind::notSupported, RefusalId::sendingNotSupported, {channel.place().shown()});
    const auto &session = m_sessions[device];
    if (auto allowed = maySend(latest(), device, channel.place().shown(), RefusalId::wordHeldByJob); !allowed)
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
    const std::size_t i = indexOf(place.node);
    const unsigned there = i < m_structure.size() ? m_structure[i].deviceCode : 0;
    if (device.deviceCode == 0)
        return refuse(RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), device.fullName()});
    if (device.deviceCode == there)
        return {};
    return refuse(RefusalKind::badInput, RingRefusalId::deviceCodeDiffers,
                  {place.shown(), hexCode(there, 4), device.fullName(), hexCode(device.deviceCode, 4)});
}

Result<void> RingSession::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    const std::size_t i = indexOf(place.node);
    if (!isOpen() || i >= m_structure.size())
        return refuse(RefusalKind::busy, RefusalId::notRunning, {place.shown()});
    RingDevice &participant = m_structure[i];
    const DeviceDescription *wanted = m_catalog.find(deviceKey);
    if (auto may = mayName(place, wanted); !may)
        return may;

    participant.deviceKey = wanted ? deviceKey : QString();
    std::optional<DeviceDescription> described;
    if (const auto *found = m_catalog.find(participant.deviceKey, participant.deviceCode))
        described = found->labelled(turns, stepsPerTurn);
    const int writes = m_sessions[i] ? m_sessions[i]->eepromWrites() : 0;
    m_retired.push_back(std::move(m_sessions[i]));
    auto driver = makeSession(i, described ? &*described : nullptr);
    if (m_sessions[i])
        m_sessions[i]->countEepromWrites(writes);
    ++m_renamings[i];
    for (const RingEvent &event : std::exchange(m_engine.waiting(), {}))
        if (event.device == i && std::holds_alternative<Event>(event.what))
            keepEepromWrites(event);
        else
            m_engine.waiting().push_back(event);
    post(command::SetDriver{i, std::move(driver), described ? described->fullName() : place.toString()});
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    endRetired();
    return {};
}

DataChecks RingSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return ringChecks(*this, m_stoppedBy, node, planned);
}

// Not open before its devices are known.
BusState RingSession::state() const
{
    if (m_engine.state() != BusState::open)
        return m_engine.state();
    if (m_generation == 0)
        return BusState::opening;
    return latest().connected ? BusState::open : BusState::lost;
}

std::optional<Participant> RingSession::found(Place place) const
{
    const auto there = std::ranges::find(m_structure, place.node, &RingDevice::number);
    return place.bus == id() && there != m_structure.end() ? std::optional<Participant>(*there)
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
    return strangersInRing(ringStructure(planned), m_structure, m_catalog);
}

std::vector<Place> RingSession::places() const
{
    std::vector<Place> places;
    for (const RingDevice &participant : m_structure)
        places.push_back(placeOf(participant.number));
    return places;
}

EncoderSession *RingSession::encoderAt(NodeId node) const
{
    const std::size_t i = indexOf(node);
    return i < m_sessions.size() ? m_sessions[i].get() : nullptr;
}

WordChannel *RingSession::channelAt(NodeId node) const
{
    const std::size_t i = indexOf(node);
    return i < m_channels.size() ? m_channels[i].get() : nullptr;
}

void RingSession::setRunning(bool on)
{
    m_stoppedBy = on ? StoppedBy::other : StoppedBy::program;
    if (on)
        post(command::StartBus{});
    else
        post(command::StopBus{});
}

void RingSession::alarmStop()
{
    m_stoppedBy = StoppedBy::alarmStop;
    const bool isGateway = isOpen() && !m_link->boundsWordsToCycles();
    if (isGateway && !m_zerosAskedAt) {
        m_zerosAskedAt = m_link->now();
        m_outBeforeZeros = outNow();
    }
    if (isGateway && latest().connected) // at once: the bus thread may hang in a transaction
        tell({.at = m_link->now(), .severity = Severity::attention, .id = RingMessageId::zerosAsked});
    if (isGateway)
        m_link->hurryToZeros();
    post(command::AlarmStop{});
}

} // namespace codewheel
