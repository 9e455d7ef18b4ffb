// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_bus.h"

namespace codewheel {

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
