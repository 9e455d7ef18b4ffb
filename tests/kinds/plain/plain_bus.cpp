// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_bus.h"

#include "jobs/job_check.h"
#include "jobs/values_to_write.h"

#include <utility>

namespace codewheel::test {
namespace {

constexpr Instant turnTime = std::chrono::milliseconds(1);

const DeviceDescription &plainDevice(const Catalog &catalog)
{
    return *catalog.find(QStringLiteral("plain-node"));
}

} // namespace

struct PlainBus::Seat
{
    Seat(PlainBus &bus, std::size_t index, Place at, const QByteArray &serialNumber)
        : place(at)
        , node({{"steps", "4096"},
                {"direction", "0"},
                {"2000:1", "0"},
                {"1008", "P1"},
                {"preset", "0"},
                {"serial-number", serialNumber}})
        , known{plainDevice(bus.catalog())}
        , session(bus, index, at, known.device)
    {
        node.turn(1'001);
    }

    Place place;
    PlainNode node;
    PlainKnowledge known;
    PlainSession session;
    std::unique_ptr<PlainRun> run{};
};

PlainBus::PlainBus(const Catalog &catalog)
    : EncoderBus(plainId, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC), plainColumns)
    , m_catalog(catalog)
    , m_outline({plainNode(plainHoist.node, QStringLiteral("Hoist encoder")),
                 plainNode(plainGate.node, QStringLiteral("Gate encoder")),
                 plainNode(plainLamp.node, QStringLiteral("Lamp"))},
                this)
{
    for (const Place place : {plainHoist, plainGate})
        m_seats.push_back(std::make_unique<Seat>(*this, m_seats.size(), place,
                                                 QByteArray::number(7'001 + int(m_seats.size()))));
    for (const auto &seat : m_seats)
        show(*seat);
}

PlainBus::~PlainBus() = default;

std::optional<Participant> PlainBus::found(Place place) const
{
    Participant participant;
    participant.number = place.node;
    if (const EncoderSession *its = encoder(place))
        participant.deviceKey = its->device().key;
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
    seat.node.turn(1);
    ask(seat);
    show(seat);
}

void PlainBus::ask(Seat &seat)
{
    if (!seat.run)
        return;
    if (const auto line = seat.run->next()) {
        const auto tellLine = [&](TrafficKind kind, const QByteArray &bytes) {
            tellTraffic({.at = m_now, .place = seat.place, .kind = kind, .bytes = bytes, .meaning = {}});
        };
        tellLine(TrafficKind::sent, *line);
        const QByteArray answer = seat.node.answer(*line);
        tellLine(TrafficKind::answer, answer);
        seat.run->answered(answer);
    }
    if (seat.run->isDone())
        seat.run.reset();
}

void PlainBus::show(Seat &seat)
{
    Reading &reading = seat.known.reading;
    reading.at = m_now;
    reading.state = seat.node.isGiven() ? EncoderState::parameterization : EncoderState::operation;
    reading.position = seat.node.position();
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
    return seatAt(place).node;
}

// It says so when it is back: what is known of it may be gone.
void PlainBus::switchOffAndOn(Place place)
{
    seatAt(place).node.switchOffAndOn();
    seatAt(place).session.forgetValues();
}

EncoderSession *PlainBus::encoderAt(NodeId node) const
{
    const auto found = std::ranges::find(m_seats, node, [](const auto &seat) { return seat->place.node; });
    return found == m_seats.end() ? nullptr : &(*found)->session;
}

QDateTime PlainSession::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

Result<std::vector<Step>> PlainSession::planned(const std::vector<Job> &jobs) const
{
    return stepsForJobs(*this, jobs, Word{});
}

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

void PlainSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = place();
    m_bus.tell(std::move(message));
}

Instant PlainSession::now() const
{
    return m_bus.now();
}

Instant PlainSession::instantOf(const QDateTime &time) const
{
    return m_bus.instantOf(time);
}

} // namespace codewheel::test
