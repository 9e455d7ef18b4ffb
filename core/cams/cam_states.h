// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/cam_program.h"
#include "words/k3_cam_word.h"

// What cams make of a position (FRABA manual 5.4.4). Positions are unsigned, in steps: 0..total range - 1.
namespace codewheel {

// Whether the position lies from start to stop, both included; start > stop goes through zero (assumed).
constexpr bool covers(const Cam &cam, std::int64_t position) noexcept
{
    const bool afterStart = position >= cam.start;
    const bool beforeStop = position <= cam.stop;
    return cam.start <= cam.stop ? afterStart && beforeStop : afterStart || beforeStop;
}

constexpr bool isOn(const Cam &cam, std::int64_t position) noexcept
{
    return cam.active && covers(cam, position);
}

// Bit n: cam n is on.
constexpr std::uint8_t states(const CamProgram &program, std::int64_t position) noexcept
{
    unsigned on = 0;
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        on |= (isOn(program.cam[n], position) ? 1U : 0U) << n;
    return static_cast<std::uint8_t>(on);
}

// Bit n: cam n is active, as in the word 2040xxxxh.
constexpr std::uint8_t activeCams(const CamProgram &program) noexcept
{
    unsigned active = 0;
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        active |= (program.cam[n].active ? 1U : 0U) << n;
    return static_cast<std::uint8_t>(active);
}

// What IN will hold: the cams in D7..D0, (position >> shift) & 1FFFFh in D24..D8.
constexpr Word camWord(const CamProgram &program, std::int64_t position) noexcept
{
    const Word shifted = (static_cast<Word>(position) & k3::dataMask) >> program.shift;
    return k3::camWord(states(program, position), shifted);
}

} // namespace codewheel
