// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_session.h"

#include "bus/bus_engine.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "kinds/esc/driver/esc_fraction_bits.h"
#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/line/esc_line_checks.h"
#include "kinds/esc/line/esc_line_encoder_session.h"
#include "kinds/esc/line/esc_line_outline.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/line/row_text.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/message_items.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {

namespace {

// Whether this may be on the label of an encoder that reports `told`, which is printed in decimal or in
// hexadecimal digits. Text that is no number, or empty, always may.
bool mayBeSerialNumber(const QString &text, std::int64_t told)
{
    bool isDecimal = false;
    bool isHexadecimal = false;
    const auto decimal = text.toLongLong(&isDecimal);
    const auto hexadecimal = text.toLongLong(&isHexadecimal, 16);
    return !isHexadecimal || (isDecimal && decimal == told) || hexadecimal == told;
}

} // namespace

struct EscLineSession::Private
{
    Private(EscLineSession &line, std::unique_ptr<ByteLink> usedLink, const Catalog &usedCatalog,
            DriverFactory factory)
        : outline(line)
        , link(std::move(usedLink))
        , catalog(usedCatalog)
        , makeDriver(std::move(factory))
        , engine(line)
    {}

    struct Encoder
    {
        // A copy, so that a driver may keep it whatever becomes of the catalog.
        std::unique_ptr<const DeviceDescription> description;
        std::unique_ptr<EscEncoderSession> session; // null: removed
    };

    const EscLineSnapshot &latest() const { return *engine.latest(); }
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

    const EscLineOutline outline;
    std::unique_ptr<ByteLink> link;
    const Catalog &catalog;
    DriverFactory makeDriver;
    SerialSettings settings;
    int fractionBits = esc::defaultFractionBits;
    std::vector<Encoder> encoders; // by the runner's index
    std::vector<Encoder> retired;  // from an earlier connection, one of which may be emitting right now
    Start start = Start::watching;
    LineState told;
    EscLineTraffic traffic;
    BusEngine<EscLineRunner, EscLineSession> engine; // destroyed before what its drivers use
};

EscLineSession::EscLineSession(std::unique_ptr<ByteLink> link, const Catalog &catalog, QDateTime begin,
                               DriverFactory makeDriver, QObject *parent, BusId id)
    : EncoderBus(id, std::move(begin), lineTrafficColumns, parent)
    , d(std::make_unique<Private>(*this, std::move(link), catalog, std::move(makeDriver)))
{
    const auto explain = [this] { d->traffic.setExplainOptions(explainOptions()); };
    connect(this, &EscLineSession::explainOptionsChanged, this, explain);
    connect(this, &EscLineSession::nodesChanged, this, explain);
    connect(this, &EscLineSession::moved, this, explain);
}

EscLineSession::~EscLineSession() = default;

Result<void> EscLineSession::open(const SerialSettings &settings, const esc::Timing &timing, Start start,
                                  Drive drive, SleepWatch::Slept slept)
{
    close();
    d->settings = settings;
    d->start = start;
    d->retireAll();
    std::optional<Pacing> pacing;
    if (drive == Drive::byThread)
        pacing.emplace(Pacing{.slept = std::move(slept)});
    auto runner = std::make_unique<EscLineRunner>(*d->link, settings, timing);
    runner->post(line_command::SetPolling{true});
    if (start == Start::operating)
        runner->post(line_command::SetOperate{true});
    return d->engine.open(std::move(runner), std::move(pacing));
}

// As it will be once the thread has carried out what was posted.
void EscLineSession::linkOpened()
{
    auto expected = std::make_shared<EscLineSnapshot>();
    static_cast<LineState &>(*expected) = {.connected = true,
                                           .lowLatency = d->link->lowLatency(),
                                           .polling = true,
                                           .operate = d->start == Start::operating};
    d->engine.setLatest(std::move(expected));
    tell({.at = now(),
          .id = EscMessageId::lineOpened,
          .arguments = {portArgument(*d->link), std::int64_t{d->settings.baudRate}}});
    showLatest();
    Q_EMIT nodesChanged();
}

void EscLineSession::close()
{
    const bool wasOpen = isOpen();
    if (!d->engine.close())
        return;
    auto closed = std::make_shared<EscLineSnapshot>(d->latest());
    static_cast<LineState &>(*closed) = {};
    d->engine.setLatest(std::move(closed));
    if (wasOpen)
        tell({.at = now(), .id = EscMessageId::lineClosed, .arguments = {portArgument(*d->link)}});
    showLatest();
}

void EscLineSession::startThread(SleepWatch::Slept slept)
{
    d->engine.startThread({.slept = std::move(slept)});
}

void EscLineSession::advance(Instant duration)
{
    d->endRetired();
    d->engine.advance(duration, duration);
}

void EscLineSession::pump()
{
    d->endRetired();
    d->engine.pump();
}

EncoderSession *EscLineSession::showing(std::size_t device) const
{
    return device < d->encoders.size() ? d->encoders[device].session.get() : nullptr;
}

void EscLineSession::showLatest()
{
    const auto shown = d->engine.latest();
    const LineState &state = *shown;
    tellState(std::exchange(d->told, state) != state);
    Freshness::Circumstances circumstances{.isConnected = isOpen(),
                                           .isLinkThere = shown->connected,
                                           .isRunning = shown->polling,
                                           .awakeSince = shown->awakeSince,
                                           .now = shown->at};
    const std::size_t count = std::min(shown->devices.size(), d->encoders.size());
    for (std::size_t i = 0; i < count; ++i) {
        EscEncoderSession *session = d->encoders[i].session.get();
        if (!session || !shown->devices[i].present)
            continue;
        const Place before = session->place();
        const Place now = placeOf(shown->devices[i].address.node());
        session->moveTo(now);
        circumstances.lateAfter = shown->devices[i].lateAfter;
        circumstances.isAnswering = shown->devices[i].answers;
        session->show(shown->devices[i].reading, circumstances);
        if (now != before)
            Q_EMIT moved(before, now);
    }
}

void EscLineSession::dispatch(const EscLineEvent &event)
{
    if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
        if (auto &session = d->encoders[event.device].session)
            session->take(*ofDriver, event.at);
    } else if (const auto *message = std::get_if<Message>(&event.what)) {
        tell(*message);
    } else if (const auto *other = std::get_if<OtherAdapter>(&event.what)) {
        Q_EMIT otherAdapterFound(other->which);
    } else if (const auto *slept = std::get_if<Slept>(&event.what)) {
        takeSleep(*slept, event.at);
    } else if (const auto *row = std::get_if<esc::EscLineRow>(&event.what)) {
        Q_EMIT passed(*row);
        TrafficRow told = d->traffic.row(*row);
        told.place = placeOf(told.place ? told.place->node : NodeId());
        tellTraffic(std::move(told));
    } else if (const auto *progress = std::get_if<ScanProgress>(&event.what)) {
        Q_EMIT scanProgressed(*progress);
    } else if (const auto *ended = std::get_if<ScanEnded>(&event.what)) {
        Q_EMIT scanEnded(*ended);
    } else if (const auto *answered = std::get_if<TypedAnswered>(&event.what)) {
        tellEnd(*answered);
    }
}

std::optional<Refusal> EscLineSession::addressTaken(EscLineAddress wanted, EscLineAddress own) const
{
    for (const EscLineAddress reading : escReadingsOf(wanted))
        if (const Private::Encoder *there = d->find(reading.node()); there != nullptr && reading != own)
            return Refusal{RefusalKind::badInput,
                           RefusalId::lineAddressTaken,
                           {reading.shown(), there->description->fullName()}};
    return std::nullopt;
}

Result<void> EscLineSession::add(EscLineAddress address, const QString &deviceKey)
{
    const Place place = placeOf(address.node());
    if (!d->engine.isBegun())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (!address.isDevice() && !address.isMaster())
        return refuse(RefusalKind::badInput, EscRefusalId::lineAddressWrong, {address.onWire()});
    if (const Private::Encoder *there = d->find(place.node))
        return refuse(RefusalKind::badInput, RefusalId::lineAddressTaken,
                      {address.shown(), there->description->fullName()});
    if (const auto others = places();
        !others.empty() && (address.isMaster() || EscLineAddress::of(others.front().node).isMaster()))
        return refuse(
            RefusalKind::badInput, EscRefusalId::lineAddressNotAlone,
            {EscLineAddress::master().shown(), (address.isMaster() ? others.front() : place).shown()});
    const DeviceDescription *described = d->catalog.find(deviceKey);
    if (!described || described->profile != profile::esc)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {deviceKey, QStringLiteral("ESC")});

    take(address, *described);
    Q_EMIT nodesChanged();
    return {};
}

EscEncoderSession &EscLineSession::take(EscLineAddress address, const DeviceDescription &device)
{
    auto description = std::make_unique<const DeviceDescription>(device);
    auto driver = d->makeDriver(*description, address);
    driver->setFractionBits(d->fractionBits);
    auto session = std::make_unique<EscEncoderSession>(*this, d->encoders.size(), address, *description);
    d->encoders.push_back({std::move(description), std::move(session)});
    post(line_command::AddDevice{std::move(driver), device.fullName()});
    return *d->encoders.back().session;
}

Result<void> EscLineSession::remove(Place place)
{
    Private::Encoder *encoder = d->find(place.node);
    if (!encoder)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    if (encoder->session->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.shown()});
    const auto ended = leave(d->indexOf(*encoder)); // whoever is told no longer finds it
    Q_EMIT nodesChanged();
    return {};
}

const BusOutline &EscLineSession::outline() const
{
    return d->outline;
}

std::unique_ptr<EscEncoderSession> EscLineSession::leave(std::size_t index)
{
    post(line_command::RemoveDevice{index});
    return std::move(d->encoders[index].session);
}

Result<void> EscLineSession::canBe(Place place, const DeviceDescription &device) const
{
    if (device.profile == profile::esc)
        return {};
    return refuse(RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), device.fullName()});
}

Result<void> EscLineSession::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    Private::Encoder *before = d->find(place.node);
    const DeviceDescription *described = d->catalog.find(deviceKey);
    if (!before || !described)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    if (auto may = mayName(place, described); !may)
        return may;
    const auto ended = leave(d->indexOf(*before));
    EscEncoderSession &now = take(EscLineAddress::of(place.node), described->labelled(turns, stepsPerTurn));
    now.countEepromWrites(ended->eepromWrites());
    setSwapsWarningBytes(place, ended->swapsWarningBytes());
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    return {};
}

const Catalog &EscLineSession::catalog() const
{
    return d->catalog;
}

std::optional<Participant> EscLineSession::found(Place place) const
{
    const EncoderSession *there = encoder(place);
    return there ? std::optional(Participant{.number = place.node, .deviceKey = there->device().key})
                 : std::nullopt;
}

std::map<NodeId, Refusal> EscLineSession::strangers(const std::vector<Participant> &planned) const
{
    std::map<NodeId, Refusal> strangers;
    for (const Participant &device : planned)
        if (encoder(device.number) == nullptr)
            strangers.emplace(device.number, whyNotThere(placeOf(device.number)));
    return strangers;
}

std::optional<Refusal> EscLineSession::isOther(Place place, const QString &deviceKey,
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
    if (!told || told->evidence != Evidence::read || mayBeSerialNumber(serialNumber, told->value.number()))
        return std::nullopt;
    return Refusal{RefusalKind::link,
                   RefusalId::serialDiffers,
                   {place.shown(), serialNumber, serialNumberText(told->value.number())}};
}

std::vector<Place> EscLineSession::places() const
{
    std::vector<Place> places;
    for (const Private::Encoder &encoder : d->encoders)
        if (encoder.session)
            places.push_back(encoder.session->place());
    std::ranges::sort(places);
    return places;
}

EncoderSession *EscLineSession::encoderAt(NodeId node) const
{
    const Private::Encoder *encoder = d->find(node);
    return encoder ? encoder->session.get() : nullptr;
}

const EscLineSnapshot::Device *EscLineSession::shown(Place place) const
{
    const Private::Encoder *encoder = d->find(place.node);
    if (!encoder)
        return nullptr;
    const std::size_t index = d->indexOf(*encoder);
    return index < d->latest().devices.size() ? &d->latest().devices[index] : nullptr;
}

void EscLineSession::post(EscLineCommand command)
{
    d->engine.post(std::move(command));
}

DataChecks EscLineSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return lineChecks(*this, node, planned);
}

BusState EscLineSession::state() const
{
    const bool isLost = d->engine.state() == BusState::open && !d->latest().connected;
    return isLost ? BusState::lost : d->engine.state();
}

bool EscLineSession::isSimulated() const
{
    return d->link->isSimulated();
}

QString EscLineSession::linkName() const
{
    return d->link->name();
}

const SerialSettings &EscLineSession::settings() const
{
    return d->settings;
}

const EscLineSnapshot &EscLineSession::latest() const
{
    return d->latest();
}

bool EscLineSession::isOperating() const
{
    return d->latest().operate;
}

bool EscLineSession::isPolling() const
{
    return d->latest().polling;
}

bool EscLineSession::isRunning() const
{
    return d->latest().connected && d->latest().polling;
}

void EscLineSession::takeOtherAdapter()
{
    post(line_command::TakeOtherAdapter{});
}

Result<void> EscLineSession::determineFractionBits(Place place)
{
    Private::Encoder *encoder = d->find(place.node);
    if (!encoder)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    const auto job = encoder->session->start(fractionBitsJob(), Pace::byItself);
    if (!job)
        return tl::unexpected(job.error());
    auto *waiting = new QObject(encoder->session.get());
    connect(encoder->session.get(), &EncoderSession::finished, waiting,
            [this, waiting, place, id = *job](const Outcome &outcome) {
                if (outcome.job != id)
                    return;
                waiting->deleteLater();
                Q_EMIT fractionBitsDetermined(place, fractionBitsOf(outcome));
            });
    return {};
}

void EscLineSession::setFractionBits(int bits)
{
    d->fractionBits = bits;
    post(line_command::SetFractionBits{bits});
    Q_EMIT explainOptionsChanged();
}

int EscLineSession::fractionBits() const
{
    return d->fractionBits;
}

void EscLineSession::setSwapsWarningBytes(Place place, bool on)
{
    Private::Encoder *encoder = d->find(place.node);
    if (!encoder || encoder->session->swapsWarningBytes() == on)
        return;
    encoder->session->m_swapsWarningBytes = on;
    post(line_command::SetSwapsWarningBytes{d->indexOf(*encoder), on});
    Q_EMIT explainOptionsChanged();
}

esc::ExplainOptions EscLineSession::explainOptions() const
{
    esc::ExplainOptions options{.fractionBits = d->fractionBits};
    for (const Private::Encoder &encoder : d->encoders)
        if (encoder.session && encoder.session->swapsWarningBytes())
            options.swapping.insert(EscLineAddress::of(encoder.session->place().node));
    return options;
}

void EscLineSession::setRunning(bool on)
{
    post(line_command::SetPolling{on});
}

void EscLineSession::setOperate(bool on)
{
    post(line_command::SetOperate{on});
}

void EscLineSession::alarmStop()
{
    post(line_command::AlarmStop{});
    Q_EMIT alarmStopped();
}

void EscLineSession::scan(const ScanWish &wish)
{
    post(line_command::Scan{wish});
}

void EscLineSession::cancelScan()
{
    post(line_command::CancelScan{});
}

// A write is accounted for before it is sent.
void EscLineSession::send(const esc::Request &request)
{
    if (isOpen() && esc::shapeOf(request.command).writes) {
        std::vector<TypedWrite> writes = writesOf(request);
        if (writes.empty() && request.to.isDevice())
            writes.push_back({placeOf(request.to.node()), request.text()});
        for (const TypedWrite &write : writes)
            Q_EMIT writeAboutToBeSent(write);
    }
    post(line_command::Send{request});
}

// For each encoder that may carry it out: at the master address that is whoever is there.
std::vector<TypedWrite> EscLineSession::writesOf(const esc::Request &request) const
{
    std::vector<TypedWrite> writes;
    for (const Place place : places()) {
        const EscLineAddress address = EscLineAddress::of(place.node);
        if (!request.to.isMaster() && address != request.to && !address.isMaster())
            continue;
        TypedWrite &write = writes.emplace_back(TypedWrite{place, request.text()});
        for (const ParameterDescription &parameter : encoder(place)->device().parameters)
            if (escWriteCommand(parameter) == request.command)
                write.values.push_back({parameter.parameter, request.data});
    }
    return writes;
}

// A write to an address where no encoder was known is reported with that address, whoever is there by now.
void EscLineSession::tellEnd(const TypedAnswered &answered)
{
    Q_EMIT typedAnswered(answered);
    const esc::Request &request = answered.request;
    const esc::ExchangeResult &result = answered.result;
    if (!esc::shapeOf(request.command).writes)
        return;
    const bool wasRefused = result.answer && result.answer->kind != esc::Answer::Kind::accepted;
    std::vector<TypedWrite> writes = writesOf(request);
    const Place addressed = placeOf(request.to.node());
    if (std::ranges::find(writes, addressed, &TypedWrite::place) == writes.end())
        writes.push_back({addressed, request.text()});
    const bool mayBeDone = result.sent > 0 && !wasRefused;
    for (const TypedWrite &write : writes) {
        if (mayBeDone)
            tellTyped(write.place, answered);
        Q_EMIT typedWriteEnded(write, mayBeDone);
    }
}

void EscLineSession::tellTyped(Place place, const TypedAnswered &answered)
{
    const std::vector<RefusalArgument> typed = esc::typedArguments(answered.request, explainOptions());
    if (answered.result.answer) {
        tell({.at = now(), .place = place, .id = EscMessageId::typedWritten, .arguments = typed});
        return;
    }
    MessageItems items{std::int64_t{1}, std::int64_t{1}}; // one item, and perhaps one EEPROM write
    addItem(items, MessageItem::typed, typed);
    tell({.at = now(),
          .place = place,
          .severity = Severity::attention,
          .id = MessageId::inDoubt,
          .arguments = items});
}

} // namespace codewheel
