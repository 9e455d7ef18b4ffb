// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/words/k3_word.h"

// Read-out of a FRABA encoder (FRABA manual 10.2): 2021000nh is answered by A0000000h + value, a code that no
// table has by A4000000h + n. In cam mode 2020xxxxh reads the cams (10.5).
namespace codewheel {

namespace {

constexpr Word unknownReadOut = 0xA400'0000;
constexpr Word codeMask = 0xFFFF;
constexpr Word multiTurnFlag = 2;
constexpr Word stepsMinusOneFlag = 1;
constexpr Word opcRegisterCode = 0xD; // + register number in bits 7..4

} // namespace

Word FrabaK3::readOutAnswer(Word out) const
{
    const Word code = out & codeMask;
    const auto value = isCamReadOut(out) ? m_cams.readOut(code) : readOutValue(code);
    return value ? k3::readOutAnswer | (*value & k3::dataMask) : unknownReadOut | code;
}

std::optional<Word> FrabaK3::readOutValue(Word code) const
{
    const ParameterSet &set = memory().active();
    switch (code) {
    case 0x0:
        return m_plate.serialNumber;
    case 0x1:
        return static_cast<Word>(set.steps - (m_plate.stepsMinusOne ? 1 : 0));
    case 0x2:
        return static_cast<Word>(set.revolutions);
    case 0x3:
        return static_cast<Word>(set.coding);
    case 0x4:
        return static_cast<Word>(set.preset);
    case 0x5:
        return static_cast<Word>(set.zeroOffset);
    case 0x6:
        return set.presetArmed ? 1 : 0;
    case 0x7:
        return m_plate.softwareVersion;
    case 0x8:
        return m_plate.operatingTime;
    case 0x9:
        return startUpMode();
    case 0xA:
        return (m_plate.stepsMinusOne ? stepsMinusOneFlag : 0) |
               (shaft().resolution().turns > 1 ? multiTurnFlag : 0);
    case 0xC: // 16-bit two's complement (assumed)
        return m_plate.temperature ? std::optional(static_cast<Word>(*m_plate.temperature) & 0xFFFF)
                                   : std::nullopt;
    default:
        return opcRegister(code);
    }
}

std::optional<Word> FrabaK3::opcRegister(Word code) const
{
    const Word number = code >> 4;
    if ((code & 0xF) != opcRegisterCode || number >= m_plate.opcRegisters.size())
        return std::nullopt;
    return m_plate.opcRegisters[number];
}

Word FrabaK3::startUpMode() const
{
    switch (m_mode) {
    case Mode::cam:
        return 2 + m_cams.program();
    case Mode::velocity:
        return 2;
    case Mode::position:
        break;
    }
    return 1;
}

} // namespace codewheel
