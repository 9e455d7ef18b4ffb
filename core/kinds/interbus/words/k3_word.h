// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/word.h"

// The 32-bit process-data words of an ENCOM profile 71 encoder (K3).
//
//         D31        D30               D29            D28..D25                        D24..D0
//   OUT   start      initialise preset manufacturer   parameter number                parameter data
//   IN    not valid  parameterization  manufacturer   parameter number, error number  position or data
//
// Source: FRABA manual 5.2 and 10.1-10.4, Baumer manual 2.2 and 2.3.
namespace codewheel {

namespace k3 {

inline constexpr int dataBits = 25;
inline constexpr Word dataMask = 0x01FF'FFFF;   // D24..D0
inline constexpr Word numberMask = 0x1E00'0000; // D28..D25
inline constexpr Word statusMask = 0xE000'0000; // D31..D29
inline constexpr Word controlMask = statusMask | numberMask;

inline constexpr std::int64_t largestTotalRange = std::int64_t{dataMask} + 1; // positions; 25 bit

// OUT
inline constexpr Word startBit = 0x8000'0000;
inline constexpr Word presetBit = 0x4000'0000;
inline constexpr Word manufacturerBit = 0x2000'0000;
inline constexpr Word readOutRequestBit = 0x0001'0000; // D16: "read out" as long as it is 1 (FRABA 10.2)

inline constexpr Word normalRunning = 0x0000'0000;
inline constexpr Word run = startBit;
inline constexpr Word initialisePreset = presetBit;
inline constexpr Word frabaPreset = presetBit | manufacturerBit;
inline constexpr Word velocityOn = 0x2040'0001;
inline constexpr Word velocityOff = 0x2040'0000;
inline constexpr Word readOut = 0x2021'0000;    // + code
inline constexpr Word camReadOut = 0x2020'0000; // + what

// IN
inline constexpr Word notValidBit = 0x8000'0000;
inline constexpr Word parameterizationBit = 0x4000'0000;
inline constexpr Word confirmation = notValidBit | parameterizationBit;
inline constexpr Word error = notValidBit;
inline constexpr Word readOutAnswer = notValidBit | manufacturerBit;

// D28..D25: parameter number of OUT, parameter or error number of IN.
constexpr unsigned number(Word word) noexcept
{
    return (word & numberMask) >> dataBits;
}
constexpr Word data(Word word) noexcept
{
    return word & dataMask;
}
constexpr Word withNumber(unsigned number) noexcept
{
    return (Word{number} << dataBits) & numberMask;
}

// "Parameter p = value", e.g. parameterWord(1, 255) = 020000FFh. number 1..15, value 0..33554431.
constexpr Word parameterWord(unsigned number, Word value) noexcept
{
    return withNumber(number) | (value & dataMask);
}

constexpr Word readOutWord(unsigned code) noexcept
{
    return readOut | (code & 0xFF);
}

// "Set encoder to default", a command of its own: 0E000000h.
inline constexpr unsigned setToDefault = 7;

// Whether any manual has a parameter, or a command, with this number: FRABA 1 to 5 and 7, Baumer 6 and 15
// too.
constexpr bool isKnownNumber(unsigned number) noexcept
{
    return (number >= 1 && number <= 7) || number == 15;
}

// A control word that asks for a parameter: D31..D29 = 000 and a number that is not 0.
constexpr bool isParameterWord(Word out) noexcept
{
    return (out & statusMask) == 0 && (out & numberMask) != 0;
}
constexpr bool isReadOutRequest(Word out) noexcept
{
    return (out & 0xFFFF'0000) == readOut;
}

// D31 D30 of IN. 01 is in no manual.
constexpr bool isOperation(Word in) noexcept
{
    return (in & confirmation) == 0;
}
constexpr bool isConfirmation(Word in) noexcept
{
    return (in & confirmation) == confirmation;
}
constexpr bool isErrorOrReadOut(Word in) noexcept
{
    return (in & confirmation) == notValidBit;
}
// FRABA only: D31..D29 = 101. With Baumer D29 means nothing.
constexpr bool isReadOutAnswer(Word in) noexcept
{
    return (in & statusMask) == readOutAnswer;
}

} // namespace k3
} // namespace codewheel
