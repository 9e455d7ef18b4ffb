// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_session.h"

#include "bus/bus_engine.h"
#include "catalog/catalog.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_checks.h"
#include "kinds/canopen/bus/canopen_encoder_session.h"
#include "kinds/canopen/bus/canopen_outline.h"
#include "kinds/canopen/bus/canopen_runner.h"
#include "kinds/canopen/bus/canopen_traffic.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {

struct CanopenSession::Private
{
    Private(CanopenSession &bus, std::unique_ptr<CanLink> usedLink, const Catalog &usedCatalog)
        : outline(bus)
        , link(std::move(usedLink))
        , catalog(usedCatalog)
        , engine(bus)
    {}

    struct Encoder
    {
        // A copy, so that a driver may keep it whatever becomes of the catalog.
        std::unique_ptr<const DeviceDescription> description;
        std::unique_ptr<CanopenEncoderSession> session; // null: removed
    };

    const CanopenSnapshot &latest() const { return *engine.latest(); }
    Encoder *find(NodeId node)
    {
        const auto found = std::ranges::find_if(encoders, [node](const Encoder &encoder) {
            return encoder.session && encoder.session->place().node == node;
        });
        return found == encoders.end() ? nullptr : &*found;
    }
    void retireAll()
    {
        std::ranges::move(std::exchange(encoders, {}), std::back_inserter(retired));
        endRetired();
    }
    void endRetired() // unless handlers may still be looking at them
    {
        if (!engine.isPumping())
            retired.clear();
    }
    std::size_t indexOf(const Encoder &encoder) const
    {
        return static_cast<std::size_t>(&encoder - encoders.data());
    }

    const CanopenOutline outline;
    std::unique_ptr<CanLink> link;
    const Catalog &catalog;
    CanopenSettings settings;
    CanopenTraffic traffic;
    std::vector<Encoder> encoders; // by the runner's index
    std::vector<Encoder> retired;  // from an earlier connection, one of which may be emitting right now
    Start start = Start::watching;
    CanopenState told;
    BusEngine<CanopenRunner, CanopenSession> engine; // destroyed before what its drivers use
};

CanopenSession::CanopenSession(std::unique_ptr<CanLink> link, const Catalog &catalog, QDateTime begin,
                               QObject *parent, BusId id)
    : EncoderBus(id, std::move(begin), canTrafficColumns, parent)
    , d(std::make_unique<Private>(*this, std::move(link), catalog))
{}

CanopenSession::~CanopenSession() = default;

Result<void> CanopenSession::open(const CanopenSettings &settings, Start start, Drive drive,
                                  SleepWatch::Slept slept)
{
    close();
    d->settings = settings;
    d->start = start;
    d->retireAll();
    std::optional<Pacing> pacing;
    if (drive == Drive::byThread)
        pacing.emplace(Pacing{.slept = std::move(slept)});
    auto runner = std::make_unique<CanopenRunner>(
        *d->link, settings.rate, start == Start::operating ? CanUse::operate : CanUse::watch);
    runner->post(canopen_command::SetRunning{true});
    return d->engine.open(std::move(runner), std::move(pacing));
}

// As it will be once the thread has carried out what was posted.
void CanopenSession::linkOpened()
{
    auto expected = std::make_shared<CanopenSnapshot>();
    static_cast<CanopenState &>(*expected) = {
        .connected = true, .running = true, .operate = d->start == Start::operating};
    d->engine.setLatest(std::move(expected));
    tell({.at = now(),
          .id = CanopenBusMessageId::opened,
          .arguments = {linkArgument(*d->link), std::int64_t{d->settings.rate}}});
    showLatest();
    Q_EMIT nodesChanged();
}

void CanopenSession::close()
{
    const bool wasOpen = isOpen();
    if (!d->engine.close())
        return;
    auto closed = std::make_shared<CanopenSnapshot>(d->latest());
    static_cast<CanopenState &>(*closed) = {};
    d->engine.setLatest(std::move(closed));
    if (wasOpen)
        tell({.at = now(), .id = CanopenBusMessageId::closed, .arguments = {linkArgument(*d->link)}});
    showLatest();
}

void CanopenSession::startThread(SleepWatch::Slept slept)
{
    d->engine.startThread({.slept = std::move(slept)});
}

void CanopenSession::advance(Instant duration)
{
    d->endRetired();
    d->engine.advance(duration, duration);
}

void CanopenSession::pump()
{
    d->endRetired();
    d->engine.pump();
}

void CanopenSession::takeUnsureWatch()
{
    if (d->engine.isBegun())
        post(canopen_command::TakeUnsureWatch{});
    else
        d->link->takeUnsureWatch();
}

void CanopenSession::mayStopNode(Place place)
{
    if (const Private::Encoder *encoder = d->find(place.node))
        post(canopen_command::MayStopNode{d->indexOf(*encoder)});
}

EncoderSession *CanopenSession::showing(std::size_t device) const
{
    return device < d->encoders.size() ? d->encoders[device].session.get() : nullptr;
}

void CanopenSession::showLatest()
{
    const auto shown = d->engine.latest();
    const CanopenState &bus = *shown;
    tellState(std::exchange(d->told, bus) != bus);
    Freshness::Circumstances circumstances{.isConnected = isOpen(),
                                           .isLinkThere = shown->connected,
                                           .isRunning = shown->running,
                                           .awakeSince = shown->awakeSince,
                                           .now = shown->at};
    const std::size_t count = std::min(shown->devices.size(), d->encoders.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (!d->encoders[i].session || !shown->devices[i].present)
            continue;
        circumstances.isAnswering = shown->devices[i].answers;
        d->encoders[i].session->show(shown->devices[i].reading, circumstances);
    }
}

void CanopenSession::dispatch(const CanopenEvent &event)
{
    if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
        if (event.device < d->encoders.size() && d->encoders[event.device].session)
            d->encoders[event.device].session->take(*ofDriver, event.at);
    } else if (const auto *message = std::get_if<Message>(&event.what)) {
        tell(*message);
    } else if (const auto *row = std::get_if<CanopenRow>(&event.what)) {
        Q_EMIT passed(*row);
        TrafficRow told = d->traffic.row(*row, event.at);
        told.place = placeOf(told.place ? told.place->node : NodeId());
        tellTraffic(std::move(told));
    } else if (const auto *sent = std::get_if<FrameSent>(&event.what)) {
        Q_EMIT frameSent(*sent);
        tellEnd(storing(sent->frame), sent->fate != CanFate::refused);
    } else if (const auto *ended = std::get_if<TransferEnded>(&event.what)) {
        using Kind = canopen::SdoOutcome::Kind;
        Q_EMIT transferEnded(*ended);
        tellEnd(storing(ended->request),
                ended->outcome.kind == Kind::written || ended->outcome.kind == Kind::noAnswer);
    } else if (const auto *lss = std::get_if<Configured>(&event.what)) {
        Q_EMIT configured(*lss);
        tellEnd(storing(lss->request), lss->outcome.kind == canopen::LssOutcome::Kind::done ||
                                           lss->outcome.kind == canopen::LssOutcome::Kind::noAnswer);
    } else if (const auto *found = std::get_if<NodesScanned>(&event.what)) {
        Q_EMIT scanned(*found);
    } else if (const auto *unsure = std::get_if<WatchNotSure>(&event.what)) {
        Q_EMIT watchNotSure(unsure->why);
    } else if (const auto *slept = std::get_if<Slept>(&event.what)) {
        takeSleep(*slept, event.at);
    }
}

Result<void> CanopenSession::add(int node, const QString &deviceKey)
{
    const CanopenAddress address{node};
    if (!d->engine.isBegun())
        return refuse(RefusalKind::link, CanopenBusRefusalId::closed);
    if (!address.isNode())
        return refuse(RefusalKind::badInput, CanopenBusRefusalId::nodeNumberWrong, {QString::number(node)});
    if (const Private::Encoder *there = d->find(address.place()))
        return refuse(RefusalKind::badInput, RefusalId::lineAddressTaken,
                      {address.shown(), there->description->fullName()});
    const DeviceDescription *described = d->catalog.find(deviceKey);
    if (described == nullptr || described->profile != profile::cia406)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice,
                      {deviceKey, QStringLiteral("CANopen")});
    take(node, *described);
    Q_EMIT nodesChanged();
    return {};
}

CanopenEncoderSession &CanopenSession::take(int node, const DeviceDescription &device)
{
    auto description = std::make_unique<const DeviceDescription>(device);
    auto driver = canopen::makeNodeDriver(*description, node);
    auto session = std::make_unique<CanopenEncoderSession>(*this, d->encoders.size(), node, *description);
    d->encoders.push_back({std::move(description), std::move(session)});
    post(canopen_command::AddNode{std::move(driver)});
    return *d->encoders.back().session;
}

Result<void> CanopenSession::remove(Place place)
{
    Private::Encoder *encoder = d->find(place.node);
    if (encoder == nullptr)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    if (encoder->session->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.shown()});
    const auto ended = leave(d->indexOf(*encoder)); // whoever is told no longer finds it
    Q_EMIT nodesChanged();
    return {};
}

std::unique_ptr<CanopenEncoderSession> CanopenSession::leave(std::size_t index)
{
    post(canopen_command::RemoveNode{index});
    return std::move(d->encoders[index].session);
}

const BusOutline &CanopenSession::outline() const
{
    return d->outline;
}

Result<void> CanopenSession::canBe(Place place, const DeviceDescription &device) const
{
    if (device.profile == profile::cia406)
        return {};
    return refuse(RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), device.fullName()});
}

Result<void> CanopenSession::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    Private::Encoder *before = d->find(place.node);
    const DeviceDescription *described = d->catalog.find(deviceKey);
    if (before == nullptr || described == nullptr)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    if (auto may = mayName(place, described); !may)
        return may;
    const auto ended = leave(d->indexOf(*before));
    CanopenEncoderSession &now =
        take(CanopenAddress::of(place.node).node, described->labelled(turns, stepsPerTurn));
    now.countEepromWrites(ended->eepromWrites());
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    return {};
}

const Catalog &CanopenSession::catalog() const
{
    return d->catalog;
}

std::optional<Participant> CanopenSession::found(Place place) const
{
    const EncoderSession *there = encoder(place);
    return there != nullptr
               ? std::optional(Participant{.number = place.node, .deviceKey = there->device().key})
               : std::nullopt;
}

std::map<NodeId, Refusal> CanopenSession::strangers(const std::vector<Participant> &planned) const
{
    std::map<NodeId, Refusal> strangers;
    for (const Participant &device : planned)
        if (encoder(device.number) == nullptr)
            strangers.emplace(device.number, whyNotThere(placeOf(device.number)));
    return strangers;
}

// Serial numbers are compared as far as both are numbers: on labels there is often more.
std::optional<Refusal> CanopenSession::isOther(Place place, const QString &deviceKey,
                                               const QString &serialNumber) const
{
    const EncoderSession *there = encoder(place);
    if (there == nullptr)
        return std::nullopt;
    const DeviceDescription *planned = d->catalog.find(deviceKey);
    if (planned != nullptr && planned->key != there->device().key)
        return Refusal{RefusalKind::link,
                       RefusalId::deviceDiffers,
                       {place.shown(), planned->fullName(), there->device().fullName()}};
    const auto told = there->known(Parameter::serialNumber);
    bool isNumber = false;
    const qlonglong label = serialNumber.toLongLong(&isNumber);
    if (!told || told->evidence != Evidence::read || !isNumber || label == told->value.number() ||
        serialNumber.toLongLong(nullptr, 16) == told->value.number())
        return std::nullopt;
    return Refusal{RefusalKind::link,
                   RefusalId::serialDiffers,
                   {place.shown(), serialNumber, serialNumberText(told->value.number())}};
}

std::vector<Place> CanopenSession::places() const
{
    std::vector<Place> places;
    for (const Private::Encoder &encoder : d->encoders)
        if (encoder.session)
            places.push_back(encoder.session->place());
    std::ranges::sort(places);
    return places;
}

EncoderSession *CanopenSession::encoderAt(NodeId node) const
{
    const Private::Encoder *encoder = d->find(node);
    return encoder != nullptr ? encoder->session.get() : nullptr;
}

void CanopenSession::post(CanopenCommand command)
{
    d->engine.post(std::move(command));
}

DataChecks CanopenSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return canopenChecks(*this, node, planned);
}

BusState CanopenSession::state() const
{
    const bool isLost = d->engine.state() == BusState::open && !d->latest().connected;
    return isLost ? BusState::lost : d->engine.state();
}

bool CanopenSession::isSimulated() const
{
    return d->link->isSimulated();
}

QString CanopenSession::linkName() const
{
    return d->link->name();
}

const CanopenSettings &CanopenSession::settings() const
{
    return d->settings;
}

int CanopenSession::rate() const
{
    return latest().status.rate.value_or(d->settings.rate);
}

const CanopenSnapshot &CanopenSession::latest() const
{
    return d->latest();
}

void CanopenSession::send(const CanFrame &frame)
{
    accountFor(storing(frame));
    post(canopen_command::Send{frame});
}

void CanopenSession::transfer(const canopen::SdoRequest &request)
{
    accountFor(storing(request));
    post(canopen_command::Transfer{request});
}

// What is written to 1010h and 1011h goes to the EEPROM. Of others nobody knows.
std::optional<TypedWrite> CanopenSession::storing(int node, const canopen::SdoObject &object,
                                                  bool isWrite) const
{
    if (!isWrite || (object.index != 0x1010 && object.index != 0x1011))
        return std::nullopt;
    return TypedWrite{placeOf(CanopenAddress{node}.place()), object.text().toLatin1()};
}

std::optional<TypedWrite> CanopenSession::storing(const canopen::SdoRequest &request) const
{
    return storing(request.node, request.object, request.value.has_value());
}

std::optional<TypedWrite> CanopenSession::storing(const CanFrame &frame) const
{
    const auto cob = frame.isExtended || frame.isRemote ? std::nullopt : canopen::CobId::of(frame.id);
    if (!cob || cob->service != canopen::CobId::Service::sdoRequest)
        return std::nullopt;
    const auto request = canopen::SdoFrame::request(frame.data());
    return request ? storing(cob->node, request->object, request->kind == canopen::SdoFrame::Kind::write)
                   : std::nullopt;
}

// Of a device without a number nobody keeps an account.
std::optional<TypedWrite> CanopenSession::storing(const canopen::LssRequest &request) const
{
    if (request.kind != canopen::LssRequest::Kind::store || request.number == 0)
        return std::nullopt;
    return TypedWrite{placeOf(CanopenAddress{request.number}.place()), QByteArrayLiteral("LSS 17h")};
}

void CanopenSession::configure(const canopen::LssRequest &request)
{
    accountFor(storing(request));
    post(canopen_command::Configure{request});
}

// Before it is sent.
void CanopenSession::accountFor(const std::optional<TypedWrite> &write)
{
    if (isOpen() && write)
        Q_EMIT writeAboutToBeSent(*write);
}

void CanopenSession::tellEnd(const std::optional<TypedWrite> &write, bool mayBeDone)
{
    if (!write)
        return;
    if (Private::Encoder *its = d->find(write->place.node); mayBeDone && its != nullptr)
        its->session->take(Event(KnowledgeChanged{.known = {}, .noLongerKnown = {}, .eepromWrites = 1}),
                           now());
    Q_EMIT typedWriteEnded(*write, mayBeDone);
}

} // namespace codewheel
