// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fraba_cams.h"
#include "kinds/interbus/simulator/simulated_k3.h"

#include <array>

namespace codewheel {

// What distinguishes one FRABA OCD-IB from another.
struct FrabaPlate
{
    Word serialNumber = 0;
    Word softwareVersion = 0x0103;
    Word operatingTime = 0; // 10 min
    bool stepsMinusOne = false;
    std::optional<int> temperature = 245; // 0.1 degC; empty: no sensor
    // 16 bit each. No manual says what the chip stores where: here its length and ID code in the first, 0 in
    // the others (assumed).
    std::array<Word, 16> opcRegisters{0x0237};
};

// FRABA OCD-IB K3 (FRABA manual 5.3, 5.4, 10): read-out, velocity mode, FRABA preset, cam
// mode.
class FrabaK3 final : public SimulatedK3
{
public:
    static constexpr std::int64_t fastestCode = 800; // steps per 1 ms: 800 kHz

    FrabaK3(PhysicalResolution resolution, std::int64_t raw, FrabaPlate plate, EncoderTiming timing = {});

    bool hasCams() const override { return true; }
    const FrabaCams &cams() const { return m_cams; }
    bool isCamOutOfRange() const override { return m_camOutOfRange; }
    void setCamOutOfRange(bool outOfRange) override;

private:
    enum class Mode : std::uint8_t { position, velocity, cam };

    bool take(Word out) override;
    void seen(Word out) override;
    bool confirm(unsigned number, Word data) override;
    Word answerTo(Word processed) override;
    Word operationWord() const override;
    std::optional<Word> fault() const override;
    void poweredUp() override { m_cams.powerUp(); }
    void wentToDefault() override;

    bool isFrabaPreset(Word out) const { return out == k3::frabaPreset && m_mode != Mode::cam; }
    bool isCamReadOut(Word out) const;
    bool holdsReadOut(Word out) const;

    void takeCommand(Word out);
    void takeParameter(Word out);
    void takePreset(Word out);
    void takeManufacturerWord(Word out);
    void takeCamWord(Word out);
    Word camAnswer(Word out);
    void switchTo(unsigned program);
    Word velocity() const;
    Word readOutAnswer(Word out) const;
    std::optional<Word> readOutValue(Word code) const;
    std::optional<Word> opcRegister(Word code) const;
    Word startUpMode() const;

    FrabaPlate m_plate;
    FrabaCams m_cams;
    Mode m_mode = Mode::position; // kept over power-off
    bool m_readsByD16 = false;
    bool m_camOutOfRange = false;
};

} // namespace codewheel
