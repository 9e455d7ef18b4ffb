// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_bus.h"

#include "can/can_bits.h"

namespace codewheel {
namespace {

constexpr int afterAcknowledge = 1 + 7; // its delimiter, end of frame
constexpr int errorFrame = 6 + 8;       // flag, delimiter
constexpr int answeredErrorFrame = errorFrame + 6;
constexpr int suspended = 8;          // a passive sender leaves the bus to others
constexpr int untilBackOn = 128 * 11; // recessive bits after bus off
constexpr int endOfFrame = 11;        // recessive bits that end a frame and count among them

} // namespace

SimulatedCanBus::BusTime SimulatedCanBus::Seat::bits(int count) const
{
    return std::chrono::duration_cast<BusTime>(std::chrono::seconds(count)) / participant->rate();
}

bool SimulatedCanBus::Transmission::isFrom(const Seat &seat) const
{
    return std::find(senders.begin(), senders.end(), seat.participant.get()) != senders.end();
}

void SimulatedCanBus::add(std::shared_ptr<CanParticipant> participant)
{
    const std::scoped_lock lock(m_mutex);
    m_seats.push_back({.participant = std::move(participant)});
}

void SimulatedCanBus::remove(const CanParticipant &participant)
{
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_seats, [&](const Seat &seat) { return seat.participant.get() == &participant; });
}

void SimulatedCanBus::advance(Instant until, const std::function<bool()> &isEnough)
{
    const std::scoped_lock lock(m_mutex);
    while (!isEnough || !isEnough()) {
        const auto next = nextTime();
        if (!next || *next > until) {
            m_now = std::max<BusTime>(m_now, until);
            for (Seat &seat : m_seats)
                lookAfter(seat);
            return;
        }
        m_now = std::max(m_now, *next);
        act();
    }
}

Instant SimulatedCanBus::now() const
{
    const std::scoped_lock lock(m_mutex);
    return instant();
}

std::optional<Instant> SimulatedCanBus::nextEvent() const
{
    const std::scoped_lock lock(m_mutex);
    const auto next = nextTime();
    return next ? std::optional(std::chrono::ceil<Instant>(*next)) : std::nullopt;
}

std::optional<SimulatedCanBus::BusTime> SimulatedCanBus::nextTime() const
{
    std::optional<BusTime> next;
    const auto consider = [&next](std::optional<BusTime> time) {
        if (time && (!next || *time < *next))
            next = time;
    };
    for (const Part &part : m_parts)
        if (part.on)
            consider(part.on->end);
    for (const Seat &seat : m_seats)
        consider(nextTimeOf(seat, m_parts[partOf(seat)]));
    return next;
}

std::optional<SimulatedCanBus::BusTime> SimulatedCanBus::nextTimeOf(const Seat &seat, const Part &part) const
{
    std::optional<BusTime> next = seat.participant->wakesAt();
    const auto consider = [&next](BusTime time) { next = std::min(next.value_or(time), time); };
    if (part.on)
        return next;
    if (seat.errors.isBusOff() && seat.participant->isOn() && seat.participant->comesBack())
        consider(seat.backAt);
    if (seat.isHeard() && seat.participant->toSend() != nullptr)
        consider(seat.isDecided ? std::max(seat.heldUntil, part.freeFrom) : m_now);
    return next;
}

void SimulatedCanBus::act()
{
    for (std::size_t part = 0; part < m_parts.size(); ++part)
        if (m_parts[part].on && m_parts[part].on->end <= m_now)
            finish(part);
    for (Seat &seat : m_seats)
        lookAfter(seat);
    for (std::size_t part = 0; part < m_parts.size(); ++part)
        if (!m_parts[part].on && m_parts[part].freeFrom <= m_now)
            begin(part);
}

void SimulatedCanBus::lookAfter(Seat &seat)
{
    if (seat.participant->wakesAt().value_or(Instant::max()) <= instant())
        seat.participant->proceed(instant());
    const bool isBack = seat.errors.isBusOff() && seat.participant->comesBack() && seat.backAt <= m_now &&
                        !m_parts[partOf(seat)].on;
    if (!seat.participant->isOn() || isBack) {
        seat.errors = {};
        tellState(seat);
    }
    decide(seat);
}

// Whether its next frame is late is drawn once, so that it stays in order with those after it.
void SimulatedCanBus::decide(Seat &seat)
{
    if (seat.isDecided || !seat.isHeard() || seat.participant->toSend() == nullptr)
        return;
    seat.isDecided = true;
    if (strikes(m_faults.late))
        seat.heldUntil = std::max(seat.heldUntil, m_now + m_faults.delay);
}

void SimulatedCanBus::begin(std::size_t part)
{
    Transmission sent = contend(part);
    if (sent.senders.empty())
        return;
    const Seat &sender = *seatOf(*sent.senders.front());
    int bits = canBits(sent.frame);
    if (sent.outcome != Transmission::Outcome::destroyed)
        sent.outcome = outcomeOf(sent, part);
    // Nobody looks whether a frame was acknowledged, and the error flag of a passive sender is recessive: who
    // only listens has a complete frame then.
    sent.isComplete = sent.outcome == Transmission::Outcome::through ||
                      (sent.outcome == Transmission::Outcome::notAcknowledged && sender.errors.isPassive());
    if (sent.outcome == Transmission::Outcome::notAcknowledged)
        bits += errorFrame - afterAcknowledge;
    else if (sent.outcome == Transmission::Outcome::destroyed)
        bits = 1 + static_cast<int>(m_random() % static_cast<unsigned>(bits)) + answeredErrorFrame;
    for (Seat &seat : m_seats)
        if (partOf(seat) == part)
            seat.follows = seat.takesPart();
    sent.begin = m_now;
    sent.end = m_now + sender.bits(bits);
    m_parts[part].freeFrom = sent.end + sender.bits(canIntermission);
    m_parts[part].on = std::move(sent);
}

// Who sends what when all begin that have something to send. Two with the same identifier but other data both
// fail; if all is the same, neither notices the other.
SimulatedCanBus::Transmission SimulatedCanBus::contend(std::size_t part)
{
    Transmission sent;
    std::uint32_t first = 0;
    for (Seat &seat : m_seats) {
        const CanFrame *frame = seat.isHeard() && partOf(seat) == part ? seat.participant->toSend() : nullptr;
        if (frame == nullptr || !seat.isDecided || seat.heldUntil > m_now)
            continue;
        const std::uint32_t precedence = canPrecedence(*frame);
        if (sent.senders.empty() || precedence < first) {
            first = precedence;
            sent = {.frame = *frame, .senders = {seat.participant.get()}, .rate = seat.participant->rate()};
        } else if (precedence == first && seat.participant->rate() == sent.rate) {
            sent.senders.push_back(seat.participant.get());
            if (frame->length != sent.frame.length || !std::ranges::equal(frame->data(), sent.frame.data()))
                sent.outcome = Transmission::Outcome::destroyed;
        }
    }
    return sent;
}

SimulatedCanBus::Transmission::Outcome SimulatedCanBus::outcomeOf(const Transmission &sent, std::size_t part)
{
    auto outcome = Transmission::Outcome::notAcknowledged;
    for (const Seat &seat : m_seats) {
        if (!seat.isHeard() || partOf(seat) != part || sent.isFrom(seat))
            continue;
        if (seat.participant->rate() == sent.rate)
            outcome = Transmission::Outcome::through;
        else if (!seat.errors.isPassive())
            return Transmission::Outcome::destroyed;
    }
    return strikes(m_faults.damaged) ? Transmission::Outcome::destroyed : outcome;
}

void SimulatedCanBus::finish(std::size_t part)
{
    Transmission sent = std::move(*m_parts[part].on);
    m_parts[part].on.reset();
    sent.frame.time = instant();
    const bool isLost = strikes(m_faults.lost);
    const bool isSentAgain = strikes(m_faults.doubled);
    for (Seat &seat : m_seats) {
        if (partOf(seat) != part)
            continue;
        if (seat.errors.isBusOff())
            seat.backAt += std::max(sent.end - sent.begin - seat.bits(endOfFrame), BusTime());
        if (!seat.takesPart() || !seat.follows)
            continue;
        if (sent.isFrom(seat))
            settleSender(seat, sent, isSentAgain);
        else
            settleListener(seat, sent, isLost);
        tellState(seat);
    }
}

void SimulatedCanBus::settleSender(Seat &seat, const Transmission &sent, bool again)
{
    switch (sent.outcome) {
    case Transmission::Outcome::through:
        if (again) {
            seat.errors.sendingFailed();
            break;
        }
        seat.errors.sent();
        seat.isDecided = false;
        seat.participant->sent(sent.frame, instant());
        break;
    case Transmission::Outcome::notAcknowledged:
        seat.errors.notAcknowledged();
        seat.participant->disturbed(CanDisturbance::notAcknowledged, instant());
        break;
    case Transmission::Outcome::destroyed:
        seat.errors.sendingFailed();
        seat.participant->disturbed(CanDisturbance::destroyed, instant());
        break;
    }
    if (seat.errors.isPassive())
        seat.heldUntil = std::max(seat.heldUntil, m_parts[partOf(seat)].freeFrom + seat.bits(suspended));
}

void SimulatedCanBus::settleListener(Seat &seat, const Transmission &sent, bool lost)
{
    const bool isUnderstood = seat.participant->rate() == sent.rate;
    const bool counts = seat.participant->acknowledges();
    if (isUnderstood && sent.isComplete) {
        if (counts)
            seat.errors.received();
        if (!lost)
            seat.participant->take(sent.frame, instant());
        return;
    }
    if (counts)
        seat.errors.receivingFailed(!isUnderstood && !seat.errors.isPassive());
    seat.participant->disturbed(CanDisturbance::destroyed, instant());
}

void SimulatedCanBus::tellState(Seat &seat)
{
    const CanState state = seat.errors.state();
    if (state == seat.told)
        return;
    seat.told = state;
    if (state == CanState::busOff)
        seat.backAt = m_now + seat.bits(untilBackOn);
    seat.participant->stateChanged(state, instant());
}

std::size_t SimulatedCanBus::partOf(const Seat &seat) const
{
    const auto number = static_cast<std::size_t>(&seat - m_seats.data());
    return m_faults.brokenAfter && number >= *m_faults.brokenAfter ? 1 : 0;
}

SimulatedCanBus::Seat *SimulatedCanBus::seatOf(const CanParticipant &participant)
{
    const auto found = std::ranges::find_if(
        m_seats, [&](const Seat &seat) { return seat.participant.get() == &participant; });
    return found == m_seats.end() ? nullptr : &*found;
}

CanErrorCounters SimulatedCanBus::errorsOf(const CanParticipant &participant) const
{
    const std::scoped_lock lock(m_mutex);
    for (const Seat &seat : m_seats)
        if (seat.participant.get() == &participant)
            return seat.errors;
    return {};
}

void SimulatedCanBus::restart(const CanParticipant &participant)
{
    const std::scoped_lock lock(m_mutex);
    if (Seat *seat = seatOf(participant))
        *seat = {.participant = seat->participant};
}

void SimulatedCanBus::setFaults(const CanBusFaults &faults)
{
    const std::scoped_lock lock(m_mutex);
    m_faults = faults;
}

CanBusFaults SimulatedCanBus::faults() const
{
    const std::scoped_lock lock(m_mutex);
    return m_faults;
}

void SimulatedCanBus::forceBusOff(const CanParticipant &participant)
{
    const std::scoped_lock lock(m_mutex);
    if (Seat *seat = seatOf(participant); seat != nullptr && seat->takesPart()) {
        seat->errors.goBusOff();
        tellState(*seat);
    }
}

} // namespace codewheel
