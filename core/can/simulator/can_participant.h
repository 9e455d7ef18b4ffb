// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

namespace codewheel {

// Why a frame did not get through, as those on the bus see it.
enum class CanDisturbance : std::uint8_t {
    destroyed,       // by an error frame
    notAcknowledged, // told to its sender only; to others it was destroyed, or, of a passive sender, complete
};

// A device on a SimulatedCanBus, which has its error counters and its times. Time is that of the bus. The
// bus calls it with its lock held: it must not call back.
class CanParticipant
{
public:
    virtual ~CanParticipant() = default;

    // Off: it takes part in nothing, and begins with counters of 0 once it is on.
    virtual bool isOn() const { return true; }
    virtual int rate() const = 0; // Bd
    // False: it only listens, and disturbs nobody.
    virtual bool acknowledges() const { return true; }
    // Whether it is back after bus off by itself, once 128 times 11 recessive bits have passed.
    virtual bool comesBack() const { return true; }

    // What it wants to send, until sent() or until it thinks better of it; null: nothing.
    virtual const CanFrame *toSend() const = 0;
    // That frame is through, and was acknowledged.
    virtual void sent(const CanFrame &frame, Instant now) = 0;
    // A frame of another; its time is set.
    virtual void take(const CanFrame &frame, Instant now) = 0;
    virtual void disturbed(CanDisturbance /*how*/, Instant /*now*/) {}
    virtual void stateChanged(CanState /*state*/, Instant /*now*/) {}

    // When it has something to do by itself; proceed() is called then, and has to move that on.
    virtual std::optional<Instant> wakesAt() const { return std::nullopt; }
    virtual void proceed(Instant /*now*/) {}
};

} // namespace codewheel
