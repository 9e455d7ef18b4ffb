// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the wire: who begins, what becomes of it, and what it does to the counters.
#include "can/can_bits.h"
#include "can/simulator/simulated_can_bus.h"

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

} // namespace codewheel
