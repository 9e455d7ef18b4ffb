// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_word.h"

// The words of FRABA's cam mode (FRABA manual 5.4.4 and 10.5).
//
//   OUT   010 nnnn + 25 bit   start position of cam n       011 nnnn + 25 bit   stop position of cam n
//         2080000x            cam program x, 0: position mode
//         2040xxxx            bit n = 1: cam n is active     201000xx            shift_iw = xx
//         202000xx            read out: 00 configuration, 1n start, 2n stop, 30 and 40 shift_iw
//   IN    D31 not valid, D24..D8 a part of the position, D7..D0 the cams
namespace codewheel::k3 {

inline constexpr Word programWord = 0x2080'0000;
inline constexpr Word camConfigurationWord = 0x2040'0000;
inline constexpr Word camShiftWord = 0x2010'0000;

inline constexpr unsigned camCount = 8;               // 0..7
inline constexpr unsigned camProgramCount = 8;        // 1..8
inline constexpr unsigned largestCamShift = 25;       // shows the cams only
inline constexpr Word camPositionPartMask = 0x1'FFFF; // D24..D8

inline constexpr unsigned camConfigurationCode = 0x00;
inline constexpr unsigned camStartCode = 0x10; // + cam
inline constexpr unsigned camStopCode = 0x20;  // + cam
// The manual's table says 30, its bit row and its example 40.
inline constexpr unsigned camShiftCode = 0x40;
inline constexpr unsigned camShiftCodeOfTable = 0x30;

// program 1..8; 0: position mode
constexpr Word selectCamProgram(unsigned program) noexcept
{
    return programWord | (program & 0xF);
}
// cam 0..7, position 0..33554431
constexpr Word setCamStart(unsigned cam, Word position) noexcept
{
    return presetBit | withNumber(cam) | (position & dataMask);
}
constexpr Word setCamStop(unsigned cam, Word position) noexcept
{
    return setCamStart(cam, position) | manufacturerBit;
}
// bit n: cam n is active
constexpr Word setActiveCams(Word active) noexcept
{
    return camConfigurationWord | (active & 0xFFFF);
}
// shift 0..25
constexpr Word setCamShift(unsigned shift) noexcept
{
    return camShiftWord | (shift & 0xFF);
}
constexpr Word readOutCams(unsigned code) noexcept
{
    return camReadOut | (code & 0xFFFF);
}

// IN in cam mode, and the parts of it.
constexpr Word camWord(std::uint8_t on, Word positionPart) noexcept
{
    return (positionPart & camPositionPartMask) << camCount | on;
}
constexpr std::uint8_t camsOn(Word in) noexcept
{
    return static_cast<std::uint8_t>(in & 0xFF);
}
constexpr Word camPositionPart(Word in) noexcept
{
    return (in >> camCount) & camPositionPartMask;
}

constexpr bool isCamPosition(Word out) noexcept
{
    return (out & confirmation) == presetBit && number(out) < camCount;
}
constexpr bool isCamStart(Word out) noexcept
{
    return isCamPosition(out) && (out & manufacturerBit) == 0;
}
constexpr bool isCamStop(Word out) noexcept
{
    return isCamPosition(out) && (out & manufacturerBit) != 0;
}
constexpr bool isProgramWord(Word out) noexcept
{
    return (out & 0xFFFF'FFF0) == programWord;
}
constexpr bool isCamConfiguration(Word out) noexcept
{
    return (out & 0xFFFF'0000) == camConfigurationWord;
}
constexpr bool isCamShift(Word out) noexcept
{
    return (out & 0xFFFF'FF00) == camShiftWord;
}
// The words that open cam parameterization and are acknowledged there.
constexpr bool isCamParameter(Word out) noexcept
{
    return isCamPosition(out) || isCamConfiguration(out) || isCamShift(out);
}
constexpr bool isCamReadOutRequest(Word out) noexcept
{
    return (out & 0xFFFF'0000) == camReadOut;
}

} // namespace codewheel::k3
