// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_offer.h"

#include "app/window/kinds/interbus/ring_at_work.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/offer_messages.h"
#include "kinds/interbus/plan/gateway_project.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/simulator/fault_plan.h"
#include "kinds/interbus/simulator/ring_training_acts.h"
#include "project/bus_kind.h"
#include "vocabulary/sentence.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
namespace {

Instant sinceStart()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

void showWords(const WordChannel &words, Seat &seat)
{
    if (!words.freshness().isLive())
        return;
    if (words.inWords() > 0)
        seat.in = words.in();
    if (words.outWords() > 0)
        seat.out = words.out();
}

} // namespace

std::vector<ServedDevice> servedDevices(const RingStructure &ring, const Catalog &catalog)
{
    std::vector<ServedDevice> devices;
    for (const ServedRegisters &registers : servedTable(ring)) {
        const RingDevice &device = ring[devices.size()];
        devices.push_back(
            {registers, nameOrTerminal(device, catalog.find(device.deviceKey, device.deviceCode))});
    }
    return devices;
}

RingOffer::RingOffer(RingAtWork &ring)
    : m_ring(ring)
{
    connect(ring.bus(), &RingSession::stateChanged, this, &RingOffer::followBus);
    connect(ring.bus(), &RingSession::structureChanged, this, [this] {
        if (offersWindowsRing())
            endAs(OfferMessageId::offerEndedWithStructure);
    });
    connect(&ring, &RingAtWork::linkChanged, this, [this] {
        if (isOn() && !m_ring.bus()->isSimulated())
            endAs(OfferMessageId::offerEndedWithRealRing);
    });
    connect(&ring.project(), &ProjectDocument::replaced, this, [this] {
        if (isOn())
            endAs(OfferMessageId::offerEndedWithProject);
    });
}

RingOffer::~RingOffer()
{
    if (isOn())
        stop();
}

void RingOffer::followBus()
{
    if (offersWindowsRing() && !m_ring.isStartingAfresh() && m_ring.bus()->state() == BusState::closed)
        endAs(OfferMessageId::offerEndedWithRing);
}

void RingOffer::goOnWith(const RingStructure &afresh)
{
    if (offersWindowsRing() && servedTable(afresh) != servedTable(m_ring.bus()->structure()))
        endAs(OfferMessageId::offerEndedWithStructure);
}

std::optional<Refusal> RingOffer::whyNot() const
{
    const bool isReal = m_ring.bus()->state() == BusState::closed
                            ? !plansTraining(m_ring.project().project(), m_ring.id())
                            : !m_ring.bus()->isSimulated();
    return isReal
               ? std::optional(Refusal{RefusalKind::notSupported, GatewayRefusalId::realRingNotOffered, {}})
               : std::nullopt;
}

// Where it listens is decided first: what is refused starts no ring.
Result<void> RingOffer::begin(const OfferWish &wish)
{
    if (isOn())
        end();
    if (auto why = whyNot())
        return tl::unexpected(*std::move(why));
    if (!wish.hasSeats && !m_ring.isOpen())
        return refuse(RefusalKind::link, GatewayRefusalId::closedRingNotOffered);
    m_guests = std::make_shared<RingGuests>();
    m_seats = {};
    for (int unit = 1; wish.hasSeats && unit <= wish.seats; ++unit)
        m_seats.add(QString::number(unit), m_ring.makeSeat());
    const auto writing = wish.readOnly ? ServedUnits::Writing::refused : ServedUnits::Writing::allowed;
    auto server =
        ModbusTcpServer::start({.host = wish.address, .port = wish.port},
                               wish.hasSeats ? m_seats.units(writing) : ServedUnits(m_guests, writing));
    if (!server) {
        m_seats = {};
        return tl::unexpected(server.error());
    }
    m_server = *std::move(server);
    m_wish = wish;
    m_news = {};
    m_plans.assign(m_seats.rings().size(), {});
    m_seats.start();
    if (!wish.hasSeats)
        m_ring.bus()->offerTo(m_guests);
    tell({.severity = reachesOthers(wish.address) ? Severity::attention : Severity::information,
          .id = OfferMessageId::offerBegun,
          .arguments = {place().address}});
    Q_EMIT changed();
    return {};
}

int RingOffer::connectedClients() const
{
    const ClientCounts counts = isOn() ? this->counts() : ClientCounts();
    return static_cast<int>(counts.came - counts.left);
}

QString RingOffer::endsForClients() const
{
    const int clients = connectedClients();
    if (clients == 0)
        return {};
    const QString who = sentence(tr("Connected clients: %1."), {QString::number(clients)});
    return place().seats > 0
               ? who + u' ' + tr("The rings of all seats end, with all that was written to them.")
               : who;
}

void RingOffer::end()
{
    if (isOn())
        endAs(OfferMessageId::offerEnded);
}

void RingOffer::endAs(MessageCode why)
{
    for (const Message &message : m_news.take(m_server->clients(), sinceStart()))
        tell(message);
    const QString address = place().address;
    stop();
    tell({.severity = why == OfferMessageId::offerEnded ? Severity::information : Severity::attention,
          .id = why,
          .arguments = {address}});
    Q_EMIT changed();
}

// First nobody reaches the rings any more, so that whoever waits for one is answered.
void RingOffer::stop()
{
    if (!m_wish.hasSeats)
        m_ring.bus()->offerTo(nullptr);
    m_guests->leave();
    m_server.reset();
    m_seats = {};
}

OfferedPlace RingOffer::place() const
{
    return {.address = shownAddress(m_server->place()),
            .reachesOthers = reachesOthers(m_wish.address),
            .readOnly = m_wish.readOnly,
            .seats = m_wish.hasSeats ? m_wish.seats : 0};
}

std::vector<Seat> RingOffer::seats(std::optional<NodeId> device) const
{
    const auto written = m_server->clients().writtenTo();
    const auto present = clients();
    std::vector<Seat> seats;
    for (const OfferedRings::Ring &ring : m_seats.rings()) {
        const int unit = static_cast<int>(seats.size()) + 1;
        RingSession &bus = *ring.training.bus;
        const StateWord state = bus.outline().state();
        const auto last = written.find(unit);
        seats.push_back({.unit = unit,
                         .clients = static_cast<int>(std::ranges::count(present, unit, &ServedClient::unit)),
                         .role = state.role,
                         .state = state.word,
                         .written = last == written.end() ? std::nullopt : std::optional(last->second),
                         .faults = standingFaultsText(ring.training.controls->places())});
        if (const WordChannel *words = device ? bus.channel(*device) : nullptr)
            showWords(*words, seats.back());
    }
    return seats;
}

RingSession &RingOffer::offeredRing() const
{
    return m_wish.hasSeats ? *m_seats.rings().front().training.bus : *m_ring.bus();
}

std::vector<ServedDevice> RingOffer::devices() const
{
    return servedDevices(offeredRing().structure(), m_ring.catalog());
}

Project RingOffer::clientProject(int unit, const QString &host) const
{
    GatewaySettings gateway{.host = host, .tcpPort = m_server->place().port, .unit = unit};
    const Project &planned = m_ring.project().project();
    const PlannedBus *bus = findBus(planned, m_ring.id());
    const QString ring = bus != nullptr ? bus->name : m_ring.nameOfNew();
    return gatewayProject(
        planned, m_ring.id(), offeredRing().structure(), servedSettings(gateway),
        m_wish.hasSeats ? sentence(tr("%1, seat %2", "the ring of a seat"), {ring, QString::number(unit)})
                        : ring);
}

std::shared_ptr<TrainingControls> RingOffer::controls(int unit) const
{
    const bool isSeat = isOn() && unit >= 1 && static_cast<std::size_t>(unit) <= m_seats.rings().size();
    return isSeat ? m_seats.rings()[static_cast<std::size_t>(unit - 1)].training.controls : nullptr;
}

void RingOffer::tellOfSeat(int unit, NodeId node, const TrainingAct &what, MessageCode id)
{
    tell({.id = id, .arguments = actAtSeat(unit, node, what)});
}

QString RingOffer::restartsForClients(int unit) const
{
    const auto all = seats({});
    const auto its = std::ranges::find(all, unit, &Seat::unit);
    if (its == all.end() || (its->clients == 0 && !its->written))
        return {};
    return sentence(tr("Connected clients: %1."), {QString::number(its->clients)}) + u' ' +
           tr("What was written to this seat is lost. Whoever is connected sees its ring stand for 2 s.");
}

void RingOffer::restart(int unit)
{
    m_seats.replace(static_cast<std::size_t>(unit - 1), m_ring.makeSeat());
    tell({.id = OfferMessageId::seatRestarted, .arguments = {std::int64_t{unit}}});
}

void RingOffer::takeFrame()
{
    if (!isOn())
        return;
    m_seats.pump();
    takePlans();
    for (const Message &message : m_news.take(m_server->clients(), sinceStart()))
        tell(message);
}

void RingOffer::takePlans()
{
    for (std::size_t i = 0; i < m_seats.rings().size(); ++i)
        for (const FaultStep &step : m_plans[i].take(m_seats.rings()[i].training.controls->planProgress()))
            tellOfSeat(static_cast<int>(i) + 1, {}, faultAct(step.fault, step.place, step.value),
                       RingMessageId::faultPlan);
}

void RingOffer::tell(Message message)
{
    message.place = Place{m_ring.id()};
    Q_EMIT messaged(message);
}

} // namespace codewheel
