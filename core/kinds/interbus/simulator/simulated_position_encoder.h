// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_device.h"
#include "simulator/turning_shaft.h"

namespace codewheel {

// A simulated K1, K2 or K4: the raw position of its shaft in IN, binary, right-justified, 0 above it (FRABA
// manual 2.1.1, 2.1.2). OUT does nothing: K1 and K2 have none, and no source says what it does in a K4.
// Without power IN is 0.
class SimulatedPositionEncoder final : public SimulatedDevice
{
public:
    // A K1 needs a resolution of at most 16 bits.
    SimulatedPositionEncoder(PhysicalResolution resolution, std::int64_t raw);

    Word cycle(Word out) override;
    void passTime(std::chrono::milliseconds time) override;

    std::optional<TrainingControls::Shaft> shaftState() const override;
    void turnTo(std::int64_t raw) override;
    void turnBy(std::int64_t rawSteps) override;
    void setSpeed(double revolutionsPerMinute) override;
    void setPower(bool on) override;
    void powerCycle() override;

private:
    void refresh();

    TurningShaft m_shaft;
    Word m_in = 0; // prepared for the next cycle
    bool m_powered = true;
    int m_offFor = 0; // cycles until a power cycle ends; 0: no power cycle
};

} // namespace codewheel
