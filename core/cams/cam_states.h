// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"

#include <optional>

// What cams make of a position (FRABA manual 5.4.4). Positions are unsigned, in steps: 0..total range - 1.
namespace codewheel {

// Whether the position lies from start to stop, both included; start > stop goes through zero (assumed).
constexpr bool covers(const Cam &cam, std::int64_t position) noexcept
{
    const bool afterStart = position >= cam.start;
    const bool beforeStop = position <= cam.stop;
    return cam.start <= cam.stop ? afterStart && beforeStop : afterStart || beforeStop;
}

// The same for all positions first..last; empty: some are covered and some are not.
constexpr std::optional<bool> covers(const Cam &cam, std::int64_t first, std::int64_t last) noexcept
{
    // What lies between the edges without passing zero: covered, or left out by a cam that goes through zero.
    const bool throughZero = cam.start > cam.stop;
    const std::int64_t from = throughZero ? cam.stop + 1 : cam.start;
    const std::int64_t to = throughZero ? cam.start - 1 : cam.stop;
    if (from > to || last < from || first > to)
        return throughZero;
    if (from <= first && last <= to)
        return !throughZero;
    return std::nullopt;
}

constexpr bool isOn(const Cam &cam, std::int64_t position) noexcept
{
    return cam.active && covers(cam, position) != cam.isInverted;
}

// Whether the cam is on wherever in first..last the shaft is; empty: it depends, within the hysteresis also
// on the direction it came from.
constexpr std::optional<bool> isOn(const Cam &cam, std::int64_t first, std::int64_t last) noexcept
{
    if (!cam.active)
        return false;
    const auto covered = covers(cam, first - cam.hysteresis, last + cam.hysteresis);
    return covered ? std::optional(*covered != cam.isInverted) : std::nullopt;
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

// Bit n: cam n is inverted.
constexpr std::uint8_t invertedCams(const CamProgram &program) noexcept
{
    unsigned inverted = 0;
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        inverted |= (program.cam[n].isInverted ? 1U : 0U) << n;
    return static_cast<std::uint8_t>(inverted);
}

} // namespace codewheel
