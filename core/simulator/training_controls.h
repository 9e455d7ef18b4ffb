// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"

#include <cstdint>
#include <vector>

namespace codewheel {

// What a trainer can do to a simulated ring while it runs. Any thread: what is asked is done at the next
// cycle.
class TrainingControls
{
public:
    static constexpr double fastest = 12'000; // rpm, mechanical limit of every shaft

    struct Shaft
    {
        DeviceNumber number;
        std::int64_t raw = 0;            // physical position, steps
        int stepsPerTurn = 0;            // physical
        int turns = 0;                   // physical
        double revolutionsPerMinute = 0; // positive: clockwise, looking at the shaft
        bool powered = true;
        bool slow = false; // confirms slowly
        bool hasBattery = false;
        bool batteryLow = false;
        int eepromWrites = 0; // since the ring began
    };

    virtual ~TrainingControls() = default;

    virtual std::vector<Shaft> shafts() const = 0; // as of the last cycle

    virtual void turnTo(DeviceNumber number, std::int64_t raw) = 0;
    virtual void turnBy(DeviceNumber number, std::int64_t rawSteps) = 0;
    virtual void setSpeed(DeviceNumber number, double revolutionsPerMinute) = 0;
    virtual void setPower(DeviceNumber number, bool on) = 0; // off, then on: a power cycle
    virtual void powerCycle(DeviceNumber number) = 0;
    virtual void setSlow(DeviceNumber number, bool slow) = 0;      // confirmations take 50 times as long
    virtual void loseParameters(DeviceNumber number) = 0;          // error 3
    virtual void setBatteryLow(DeviceNumber number, bool low) = 0; // shows at the next power-up
};

} // namespace codewheel
