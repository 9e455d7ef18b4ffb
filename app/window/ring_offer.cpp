// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ring_offer.h"

#include "app/window/ring_at_work.h"
#include "catalog/catalog.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
namespace {

Instant sinceStart()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

} // namespace

std::vector<ServedDevice> servedDevices(const RingStructure &ring, const Catalog &catalog)
{
    std::vector<ServedDevice> devices;
    for (const ServedRegisters &registers : servedTable(ring)) {
        const Participant &device = ring[devices.size()];
        devices.push_back(
            {registers, participantName(device, catalog.find(device.deviceKey, device.deviceCode))});
    }
    return devices;
}

RingOffer::RingOffer(RingAtWork &ring)
    : m_ring(ring)
{
    connect(ring.bus(), &RingSession::stateChanged, this, &RingOffer::followBus);
    connect(ring.bus(), &RingSession::structureChanged, this, [this] {
        if (offersWindowsRing())
            endAs(MessageId::offerEndedWithStructure);
    });
    connect(&ring, &RingAtWork::linkChanged, this, [this] {
        if (isOn() && !m_ring.bus()->isSimulated())
            endAs(MessageId::offerEndedWithRealRing);
    });
    connect(&ring.project(), &ProjectDocument::replaced, this, [this] {
        if (isOn())
            endAs(MessageId::offerEndedWithProject);
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
        endAs(MessageId::offerEndedWithRing);
}

void RingOffer::goOnWith(const RingStructure &afresh)
{
    if (offersWindowsRing() && servedTable(afresh) != servedTable(m_ring.bus()->structure()))
        endAs(MessageId::offerEndedWithStructure);
}

std::optional<Refusal> RingOffer::whyNot() const
{
    const bool isReal = m_ring.bus()->state() == BusState::closed
                            ? !plansTraining(m_ring.project().project(), m_ring.id())
                            : !m_ring.bus()->isSimulated();
    return isReal ? std::optional(Refusal{RefusalKind::notSupported, RefusalId::realRingNotOffered, {}})
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
        return refuse(RefusalKind::link, RefusalId::closedRingNotOffered);
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
    m_seats.start();
    if (!wish.hasSeats)
        m_ring.bus()->offerTo(m_guests);
    tell({.severity = reachesOthers(wish.address) ? Severity::attention : Severity::information,
          .id = MessageId::offerBegun,
          .arguments = {place().address}});
    Q_EMIT changed();
    return {};
}

void RingOffer::end()
{
    if (isOn())
        endAs(MessageId::offerEnded);
}

void RingOffer::endAs(MessageId why)
{
    for (const Message &message : m_news.take(m_server->clients(), sinceStart()))
        tell(message);
    const QString address = place().address;
    stop();
    tell({.severity = why == MessageId::offerEnded ? Severity::information : Severity::attention,
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

std::vector<Seat> RingOffer::seats() const
{
    const auto written = m_server->clients().writtenTo();
    const auto present = clients();
    std::vector<Seat> seats;
    for (const OfferedRings::Ring &ring : m_seats.rings()) {
        const int unit = static_cast<int>(seats.size()) + 1;
        const StateWord state = ring.training.bus->outline().state();
        const auto last = written.find(unit);
        seats.push_back({.unit = unit,
                         .clients = static_cast<int>(std::ranges::count(present, unit, &ServedClient::unit)),
                         .role = state.role,
                         .state = state.word,
                         .written = last == written.end() ? std::nullopt : std::optional(last->second)});
    }
    return seats;
}

std::vector<ServedDevice> RingOffer::devices() const
{
    return servedDevices(m_wish.hasSeats ? m_seats.rings().front().training.bus->structure()
                                         : m_ring.bus()->structure(),
                         m_ring.catalog());
}

void RingOffer::restart(int unit)
{
    m_seats.replace(static_cast<std::size_t>(unit - 1), m_ring.makeSeat());
    tell({.id = MessageId::seatRestarted, .arguments = {std::int64_t{unit}}});
}

void RingOffer::takeFrame()
{
    if (!isOn())
        return;
    m_seats.pump();
    for (const Message &message : m_news.take(m_server->clients(), sinceStart()))
        tell(message);
}

void RingOffer::tell(Message message)
{
    message.place = Place{m_ring.id()};
    Q_EMIT messaged(message);
}

} // namespace codewheel
