// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/reading.h"

namespace codewheel {

// Whether what an encoder showed last is still current. Decided here alone: whatever shows a position, a
// word, a value or a cam asks for it (EncoderSession::freshness(), WordChannel::freshness()).
class Freshness
{
public:
    enum class State : std::uint8_t {
        unknown, // nothing was ever shown
        live,
        old, // it was so once; nobody knows what it is now
    };
    // Why it is not live.
    enum class Reason : std::uint8_t {
        none,         // it is
        notSeen,      // nothing has come yet
        disconnected, // by the user
        linkLost,     // the port is gone, or the peer does not answer
        stopped,      // the bus is not running, or positions are not polled: ALARM STOP, a fault, or the user
        notOnBus,     // the segment is off, or behind a fault
        unsettled,    // its word is read, and no two reads agree
        silent,       // it does not answer
        notAsked,     // not for longer than it may be late: something else keeps the line busy
        watched,      // likewise: in Watch nothing is sent, and it tells nothing by itself
        heldBack,     // likewise: another master is at work, or J1939
        nodeStopped,  // likewise: it was told to be silent
        slept,        // the computer has slept since
        recorded,     // it is of a recording
        notRecorded,  // likewise, and nobody recorded it
    };

    // Nothing is wrong with it: it is only not asked.
    static bool isOnlyNotAsked(Reason reason)
    {
        return reason == Reason::notAsked || reason == Reason::watched || reason == Reason::heldBack;
    }

    // How late the next one may be at most.
    static constexpr std::chrono::seconds lateAfter{5};

    // The state of the encoder's bus.
    struct Circumstances
    {
        bool isConnected = false;
        bool isLinkThere = true;
        bool isRunning = false;
        bool isOnBus = true;
        bool isSettled = true; // its word can be believed
        Instant awakeSince{};  // the computer slept until then, so what was shown before does not count
        Instant now{};
        Instant lateAfter = Freshness::lateAfter; // where it is asked more often, it is old sooner
        bool isAnswering = true;                  // its last request was answered
        Reason whyNotAsked = Reason::notAsked;    // if it is not
    };

    Freshness() = default;
    // `seen`: when it was shown; empty: never.
    Freshness(std::optional<Instant> seen, const Circumstances &bus);
    Freshness(const Reading &reading, const Circumstances &bus);
    // Of a recording, as it was at that time; empty: nobody recorded it.
    static Freshness ofRecording(std::optional<Instant> at);

    State state() const { return m_state; }
    Reason reason() const { return m_reason; }
    bool isLive() const { return m_state == State::live; }
    bool isOld() const { return m_state == State::old; }
    bool isOfRecording() const { return m_reason == Reason::recorded || m_reason == Reason::notRecorded; }
    Instant seen() const { return m_seen; } // on the clock of the bus; meaningless if unknown

    // Whether both are shown alike: the time may differ.
    bool isSameStateAs(const Freshness &other) const
    {
        return m_state == other.m_state && m_reason == other.m_reason;
    }

private:
    State m_state = State::unknown;
    Reason m_reason = Reason::notSeen;
    Instant m_seen{};
};

} // namespace codewheel
