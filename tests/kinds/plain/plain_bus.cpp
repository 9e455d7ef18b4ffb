// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_bus.h"

#include "jobs/job_check.h"
#include "tests/kinds/plain/plain_meaning.h"

#include <utility>

namespace codewheel::test {
namespace {

constexpr Instant turnTime = std::chrono::milliseconds(1);

const QString plainKind = QStringLiteral("plain-node");
const QString telegramKind = QStringLiteral("telegram-node");

PlainPeer::Values factoryValues(const QByteArray &name)
{
    return {{"steps", "4096"}, {"direction", "0"}, {"2000:1", "0"}, {"1008", name}};
}

std::unique_ptr<PlainPeer> peer(const QString &deviceKey, std::size_t index)
{
    if (deviceKey == telegramKind)
        return std::make_unique<TelegramNode>(factoryValues({}));
    auto values = factoryValues("P1");
    values["preset"] = "0";
    values["serial-number"] = QByteArray::number(7'001 + int(index));
    return std::make_unique<PlainNode>(values);
}

std::vector<Place> placesOf(const std::vector<PlainStation> &stations)
{
    std::vector<Place> places;
    for (const PlainStation &station : stations)
        places.push_back(station.place);
    return places;
}

std::vector<BusNode> nodesOf(const std::vector<PlainStation> &stations)
{
    std::vector<BusNode> nodes;
    for (const PlainStation &station : stations)
        nodes.push_back(plainNode(station.place.node, station.name));
    return nodes;
}

} // namespace

std::vector<PlainStation> plainStations()
{
    return {{plainHoist, QStringLiteral("Hoist encoder"), plainKind},
            {plainGate, QStringLiteral("Gate encoder"), plainKind},
            {plainLamp, QStringLiteral("Lamp")}};
}

std::vector<PlainStation> telegramStations()
{
    return {{telegramWinch, QStringLiteral("Winch encoder"), telegramKind},
            {telegramCrab, QStringLiteral("Crab encoder"), telegramKind}};
}

struct PlainBus::Seat
{
    Seat(PlainBus &bus, std::size_t index, const PlainStation &station)
        : place(station.place)
        , node(peer(station.deviceKey, index))
        , known{*bus.catalog().find(station.deviceKey)}
        , session(bus, index, station.place, known.device)
    {
        node->turn(1'001);
    }

    Place place;
    std::unique_ptr<PlainPeer> node;
    PlainKnowledge known;
    PlainSession session;
    std::unique_ptr<PlainRun> run{};
};

PlainBus::PlainBus(const Catalog &catalog, const std::vector<PlainStation> &stations)
    : EncoderBus(plainId, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC), plainColumns)
    , m_catalog(catalog)
    , m_places(placesOf(stations))
    , m_outline(nodesOf(stations), this)
{
    for (const PlainStation &station : stations)
        if (!station.deviceKey.isEmpty())
            m_seats.push_back(std::make_unique<Seat>(*this, m_seats.size(), station));
    for (const auto &seat : m_seats) {
        takePosition(*seat);
        show(*seat);
    }
}

PlainBus::~PlainBus() = default;

std::optional<Participant> PlainBus::found(Place place) const
{
    Participant participant;
    participant.number = place.node;
    if (const EncoderSession *its = encoder(place)) {
        participant.deviceKey = its->device().key;
        participant.details = KindData(PlainDetails{.inputBytes = 3});
    }
    return std::ranges::count(places(), place) > 0 ? std::optional(participant) : std::nullopt;
}

// There is only one make.
Result<void> PlainBus::name(Place place, const QString & /*deviceKey*/, int, int)
{
    if (encoder(place) == nullptr)
        return {};
    seatAt(place).session.forgetValues();
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    return {};
}

void PlainBus::advance(Instant duration)
{
    for (const Instant end = m_now + duration; m_now < end;) {
        m_now += turnTime;
        for (const auto &seat : m_seats)
            turn(*seat);
    }
    Q_EMIT updated();
}

void PlainBus::turn(Seat &seat)
{
    seat.node->turn(1);
    ask(seat);
    takePosition(seat);
    show(seat);
}

void PlainBus::ask(Seat &seat)
{
    if (!seat.run)
        return;
    if (const auto line = seat.run->next()) {
        if (const QByteArray answer = exchange(seat, *line); !answer.isEmpty())
            seat.run->answered(answer);
        else
            seat.run->stop({RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("No answer.")}});
    }
    if (seat.run->isDone())
        seat.run.reset();
}

QByteArray PlainBus::exchange(Seat &seat, const QByteArray &line)
{
    const auto tellLine = [&](TrafficKind kind, const QByteArray &bytes) {
        tellTraffic({.at = m_now, .place = seat.place, .kind = kind, .bytes = bytes, .meaning = [=, &seat] {
                         return plainMeaning(seat.known.device, bytes);
                     }});
    };
    tellLine(TrafficKind::sent, line);
    const QByteArray answer = seat.node->answer(line);
    if (!answer.isEmpty())
        tellLine(TrafficKind::answer, answer);
    return answer;
}

// A plain node has it in its input, the other kind has to be asked.
void PlainBus::takePosition(Seat &seat)
{
    Reading &reading = seat.known.reading;
    reading.at = m_now;
    if (const auto *node = dynamic_cast<const PlainNode *>(seat.node.get())) {
        reading.state = node->isGiven() ? EncoderState::parameterization : EncoderState::operation;
        reading.position = node->position();
    } else {
        takeTelegramPosition(exchange(seat, "at"), seat.known);
    }
}

void PlainBus::show(Seat &seat)
{
    const Reading &reading = seat.known.reading;
    for (const Event &event : std::exchange(seat.known.events, {}))
        seat.session.take(event, m_now);
    Q_EMIT seat.session.shown({{.at = m_now, .position = reading.position}});
    seat.session.show(reading, {.isConnected = m_isOpen, .isRunning = m_isOpen, .now = m_now});
}

void PlainBus::carryOut(JobCommand command)
{
    const auto seatOf = [&](std::size_t device) -> Seat & { return *m_seats.at(device); };
    if (auto *start = std::get_if<command::StartJob>(&command)) {
        Seat &seat = seatOf(start->device);
        if (const auto checked = checkJob(seat.known.device, start->job); !checked) {
            seat.known.events.emplace_back(notTaken(start->id, checked.error(), seat.known.reading.state));
            return;
        }
        seat.run = std::make_unique<PlainRun>(start->id, start->job, start->pace, seat.known);
    } else if (const auto *known = std::get_if<command::SetKnown>(&command)) {
        seatOf(known->device).known.values.set(known->known);
    } else if (const auto *proceed = std::get_if<command::Proceed>(&command)) {
        if (seatOf(proceed->device).run)
            seatOf(proceed->device).run->proceed();
    } else if (const auto *cancel = std::get_if<command::Cancel>(&command)) {
        if (seatOf(cancel->device).run)
            seatOf(cancel->device).run->cancel(cancel->how, m_now);
    }
}

void PlainBus::setOperate(bool on)
{
    m_isOperating = on;
    tellState();
}

void PlainBus::endJobs(const Refusal &why)
{
    for (const auto &seat : m_seats) {
        if (seat->run)
            seat->run->stop(why);
        seat->run.reset();
        show(*seat);
    }
}

void PlainBus::alarmStop()
{
    endJobs({RefusalKind::stopped, RefusalId::alarmStop, {}});
}

void PlainBus::close()
{
    m_isOpen = false;
    endJobs({RefusalKind::stopped, RefusalId::busStopped, {}});
    tellState();
}

PlainBus::Seat &PlainBus::seatAt(Place place)
{
    return **std::ranges::find(m_seats, place, [](const auto &seat) { return seat->place; });
}

PlainNode &PlainBus::node(Place place)
{
    return dynamic_cast<PlainNode &>(*seatAt(place).node);
}

TelegramNode &PlainBus::telegram(Place place)
{
    return dynamic_cast<TelegramNode &>(*seatAt(place).node);
}

// A plain node has what it stored; the other kind says itself that it lost its values.
void PlainBus::switchOffAndOn(Place place)
{
    Seat &seat = seatAt(place);
    seat.node->switchOffAndOn();
    if (seat.known.device.profile == plainProfile)
        seat.session.forgetWhatWasNotStored();
}

EncoderSession *PlainBus::encoderAt(NodeId node) const
{
    const auto found = std::ranges::find(m_seats, node, [](const auto &seat) { return seat->place.node; });
    return found == m_seats.end() ? nullptr : &(*found)->session;
}

PlainSession::PlainSession(PlainBus &bus, std::size_t index, Place place, const DeviceDescription &device)
    : EncoderOnBus(bus, index, place, device)
    , m_bus(bus)
{}

Result<void> PlainSession::mayStart(const Job &job) const
{
    if (!m_bus.isOpen())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    if (!m_bus.isOperating() && !std::holds_alternative<ReadParameters>(job))
        return refuse(RefusalKind::busy, RefusalId::watchOnly, {place().shown()});
    return {};
}

void PlainSession::post(JobCommand command)
{
    m_bus.carryOut(std::move(command));
}

} // namespace codewheel::test
