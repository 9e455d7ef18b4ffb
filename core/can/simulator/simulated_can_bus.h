// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "can/simulator/can_bus_faults.h"
#include "can/simulator/can_participant.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <vector>

namespace codewheel {

// The error counters of one controller, and the state that follows from them (ISO 11898-1, 12.1.4).
class CanErrorCounters
{
public:
    // A frame that it sent was destroyed.
    void sendingFailed() { m_transmit += 8; }
    // Nobody has acknowledged it, which a passive sender does not count: alone on a bus, none goes bus off.
    void notAcknowledged() { m_transmit += isPassive() ? 0 : 8; }
    void sent() { m_transmit -= m_transmit > 0 ? 1 : 0; }
    // A frame of another was destroyed; `first`: by its own error frame, to which the others have answered.
    void receivingFailed(bool first) { m_receive = std::min(m_receive + (first ? 9 : 1), passiveFrom); }
    void received() { m_receive = m_receive >= passiveFrom ? afterPassive : std::max(m_receive - 1, 0); }
    void goBusOff() { m_transmit = busOffFrom; }

    int transmit() const { return m_transmit; }
    int receive() const { return m_receive; }
    bool isPassive() const { return std::max(m_transmit, m_receive) >= passiveFrom; }
    bool isBusOff() const { return m_transmit >= busOffFrom; }
    CanState state() const
    {
        if (isBusOff())
            return CanState::busOff;
        if (isPassive())
            return CanState::passive;
        return std::max(m_transmit, m_receive) >= warningFrom ? CanState::warning : CanState::active;
    }

private:
    static constexpr int warningFrom = 96;
    static constexpr int passiveFrom = 128;
    static constexpr int busOffFrom = 256;
    static constexpr int afterPassive = 119; // 119 to 127 are allowed

    int m_transmit = 0;
    int m_receive = 0;
};

// A CAN bus in process: who sends, for how long, who acknowledges, and whose errors count. Every frame takes
// the time of its real bits at its sender's rate. Who has another rate understands nothing and destroys it,
// until it is passive. Time is an argument; calls may come from any thread.
class SimulatedCanBus
{
public:
    explicit SimulatedCanBus(std::uint32_t seed = 1)
        : m_random(seed)
    {}

    void add(std::shared_ptr<CanParticipant> participant);
    void remove(const CanParticipant &participant);

    // Lets time pass up to `until`; with `isEnough`, to the first event after which it is true, if it is not
    // so already.
    void advance(Instant until, const std::function<bool()> &isEnough = {});
    Instant now() const;
    // When something happens next; empty: nothing ever does, if nobody does anything.
    std::optional<Instant> nextEvent() const;

    CanErrorCounters errorsOf(const CanParticipant &participant) const;
    // Its controller begins anew.
    void restart(const CanParticipant &participant);
    // Guards the participants: use it for all that is done to one from outside.
    template <typename Change>
    auto locked(Change change) const
    {
        const std::scoped_lock lock(m_mutex);
        return change();
    }

    // For the trainer.
    void setFaults(const CanBusFaults &faults);
    CanBusFaults faults() const;
    void forceBusOff(const CanParticipant &participant);

private:
    using BusTime = std::chrono::nanoseconds; // a bit of 800 kBd has 1250

    struct Seat
    {
        std::shared_ptr<CanParticipant> participant;
        CanErrorCounters errors{};
        CanState told = CanState::active;
        BusTime heldUntil{};    // it sends nothing before
        BusTime backAt{};       // after bus off
        bool isDecided = false; // whether its present frame is late
        bool follows = false;   // has been there since the present transmission began

        bool takesPart() const { return participant->isOn() && !errors.isBusOff(); }
        // Without listening only.
        bool isHeard() const { return takesPart() && participant->acknowledges(); }
        BusTime bits(int count) const;
    };
    struct Transmission
    {
        enum class Outcome : std::uint8_t { through, notAcknowledged, destroyed };
        CanFrame frame;
        std::vector<const CanParticipant *> senders; // several of the very same frame, or of two that collide
        int rate = 0;
        Outcome outcome = Outcome::through;
        bool isComplete = false; // to those who understand its rate
        BusTime begin{};
        BusTime end{};

        bool isFrom(const Seat &seat) const;
    };
    // The wire, or, where it is broken, one of its two parts.
    struct Part
    {
        BusTime freeFrom{};
        std::optional<Transmission> on{};
    };

    std::optional<BusTime> nextTime() const;
    std::optional<BusTime> nextTimeOf(const Seat &seat, const Part &part) const;
    void act();
    void lookAfter(Seat &seat);
    void decide(Seat &seat);
    void begin(std::size_t part);
    Transmission contend(std::size_t part);
    Transmission::Outcome outcomeOf(const Transmission &sent, std::size_t part);
    void finish(std::size_t part);
    void settleSender(Seat &seat, const Transmission &sent, bool again);
    void settleListener(Seat &seat, const Transmission &sent, bool lost);
    void tellState(Seat &seat);
    std::size_t partOf(const Seat &seat) const;
    Seat *seatOf(const CanParticipant &participant);
    bool strikes(int ofThousand) { return static_cast<int>(m_random() % 1'000) < ofThousand; }
    Instant instant() const { return std::chrono::floor<Instant>(m_now); }

    mutable std::mutex m_mutex;
    std::vector<Seat> m_seats; // in the order of the wire
    std::array<Part, 2> m_parts;
    CanBusFaults m_faults;
    std::mt19937 m_random; // its sequence is the same on every platform
    BusTime m_now{};
};

} // namespace codewheel
