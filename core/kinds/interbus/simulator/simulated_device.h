// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_controls.h"
#include "vocabulary/word.h"

#include <chrono>
#include <optional>

namespace codewheel {

// One device of a simulated ring: takes OUT and gives IN once per bus cycle of 1 ms, and lets the trainer see
// and operate its mechanical parts. What does not apply to a device has no effect. Used by SimulatedRing.
class SimulatedDevice
{
public:
    static constexpr int powerCycleCycles = 50; // off, then on again

    SimulatedDevice() = default;
    virtual ~SimulatedDevice() = default;
    SimulatedDevice(const SimulatedDevice &) = delete;
    SimulatedDevice &operator=(const SimulatedDevice &) = delete;

    // OUT goes in; IN as prepared in the previous cycle comes out.
    virtual Word cycle(Word out) = 0;

    // Time passes without a cycle, while a cycle is late: what moves keeps moving.
    virtual void passTime(std::chrono::milliseconds /*time*/) {}

    // The state of its shaft or rod; empty if the device has none. The ring adds the number.
    virtual std::optional<TrainingControls::Shaft> shaftState() const { return std::nullopt; }
    virtual std::optional<TrainingControls::Rod> rodState() const { return std::nullopt; }

    virtual void turnTo(std::int64_t /*raw*/) {}
    virtual void turnBy(std::int64_t /*rawSteps*/) {}
    virtual void setSpeed(double /*revolutionsPerMinute*/) {}

    virtual void moveMagnetTo(double /*millimetres*/) {}
    virtual void setMagnetSpeed(double /*millimetresPerSecond*/) {}
    virtual void setMagnetInRange(bool /*inRange*/) {}

    virtual void setPower(bool /*on*/) {}
    virtual void powerCycle() {}
    virtual void setSlow(bool /*slow*/) {}
    virtual void loseParameters() {}
    virtual void setBatteryLow(bool /*low*/) {}
    virtual void setEepromWornOut(bool /*wornOut*/) {}
    virtual void setCodeDiscFaulty(bool /*faulty*/) {}
    virtual void setCamOutOfRange(bool /*outOfRange*/) {}
};

} // namespace codewheel
