// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/rod_magnet.h"
#include "kinds/interbus/simulator/simulated_device.h"

namespace codewheel {

// A simulated TR LA-66 and its rod: the services with the handshake of the service bit (LA-66 manual 3 and
// 4), a magnet that may leave the measuring range, parameters in EEPROM. Used by SimulatedRing.
class SimulatedLa66 final : public SimulatedDevice
{
public:
    // As delivered; what the manual does not say is assumed.
    struct Parameters
    {
        Word direction = 0;            // 1: counts down towards the end of the rod
        Word measuringLength = 50'000; // steps over the length of the rod
        Word externalPreset = 0;
        Word offset = 0; // of the preset adjustment, 24 bit
    };

    static constexpr int usualProcessing = 2; // bus cycles from the service bit to its answer (assumed)
    static constexpr int slowFactor = 50;

    explicit SimulatedLa66(double lengthMillimetres, int processing = usualProcessing);

    Word cycle(Word out) override;
    void passTime(std::chrono::milliseconds time) override;

    std::optional<TrainingControls::Rod> rodState() const override;
    const Parameters &parameters() const { return m_parameters; }
    int eepromWrites() const { return m_eepromWrites; }

    void moveMagnetTo(double millimetres) override;
    void setMagnetSpeed(double millimetresPerSecond) override { m_magnet.setSpeed(millimetresPerSecond); }
    void setMagnetInRange(bool inRange) override { m_magnetInRange = inRange; }
    void setPower(bool on) override;
    void powerCycle() override;
    void setSlow(bool slow) override { m_slow = slow; }

private:
    enum class Phase : std::uint8_t { off, normal, processing, answered };

    void look();
    void refresh();
    void passOffTime();
    void switchOn();
    void see(Word out);
    Word answerTo(Word out);
    bool write(Word out);
    Word read(unsigned service);
    Word readErrorStatus();
    Word counted() const;
    Word position() const;

    RodMagnet m_magnet;
    int m_processing;
    Parameters m_parameters; // in EEPROM: every accepted write is stored at once
    int m_eepromWrites = 0;

    Phase m_phase = Phase::normal;
    bool m_slow = false;
    bool m_magnetInRange = true;
    bool m_error = false;      // the magnet left the range, and nobody has read the error status since
    std::int64_t m_seenAt = 0; // nm: where the magnet was last seen
    Word m_in = 0;             // prepared for the next cycle
    Word m_request = 0;        // while it is being processed
    Word m_answer = 0;         // in IN until the service bit is 0
    int m_remaining = 0;       // cycles left of processing, or of a power cycle
    bool m_serviceBit = true;  // of the last OUT; a bit already set at power-up is not an edge
};

} // namespace codewheel
