// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_k3.h"

namespace codewheel {

// Baumer GXP6W K3 (Baumer manual): codings, offset, measuring range, battery, faults 13 to 15. D29 means
// nothing here, values are checked at run, and there is no read-out.
class BaumerK3 final : public SimulatedK3
{
public:
    static constexpr int startUpCycles = 20; // battery test, loading, check (assumed)
    static constexpr EncoderTiming usualTiming{.startUp = startUpCycles};

    BaumerK3(PhysicalResolution resolution, std::int64_t raw, EncoderTiming timing = usualTiming);

    bool hasBattery() const override { return true; }
    bool isBatteryLow() const override { return m_batteryLow; }
    bool reportsFaults() const override { return true; }
    bool isCodeDiscFaulty() const override { return m_codeDiscFaulty; }
    void setBatteryLow(bool low) override { m_batteryLow = low; }
    void setEepromWornOut(bool wornOut) override { memory().setWornOut(wornOut); }
    void setCodeDiscFaulty(bool faulty) override;

private:
    bool take(Word out) override;
    bool confirm(unsigned number, Word data) override;
    Word operationWord() const override { return arithmetic().codedValue(shaft().raw()); }
    std::optional<unsigned> startUpError() const override;
    std::optional<Word> fault() const override;

    void takeParameter(Word out);

    bool m_batteryLow = false;
    bool m_codeDiscFaulty = false;
};

} // namespace codewheel
