// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"

#include <bitset>
#include <optional>

// A cam program value by value: first what a K3 has, which takes and reports each with a word of its own,
// then what cams of other kinds have in addition.
namespace codewheel {

enum class CamValue : std::uint8_t { start, stop, activeCams, shift, hysteresis, invertedCams };

struct CamField
{
    CamValue value = CamValue::start;
    unsigned cam = 0; // of start, stop and hysteresis: 0..7

    friend constexpr bool operator==(const CamField &, const CamField &) = default;
};

// Everything a K3 has of a program, in the order in which it is written: start and stop cam by cam, the
// active cams, shift; then what has no word: the hysteresis cam by cam, the inverted cams.
inline constexpr std::size_t camFieldCount = 2 * CamProgram::cams + 2;
inline constexpr std::size_t allCamFieldCount = camFieldCount + CamProgram::cams + 1;
using CamFieldSet = std::bitset<camFieldCount>;
constexpr CamField camField(std::size_t index)
{
    const auto cam = static_cast<unsigned>(index / 2);
    if (cam < CamProgram::cams)
        return {index % 2 == 0 ? CamValue::start : CamValue::stop, cam};
    if (index < camFieldCount)
        return {index == camFieldCount - 1 ? CamValue::shift : CamValue::activeCams, 0};
    if (index < allCamFieldCount - 1)
        return {CamValue::hysteresis, static_cast<unsigned>(index - camFieldCount)};
    return {CamValue::invertedCams, 0};
}
std::size_t indexOf(CamField field);

// Active and inverted cams as bits; bits of the 16 that belong to no cam are dropped.
std::int64_t valueOf(const CamProgram &program, CamField field);
void setValue(CamProgram &program, CamField field, std::int64_t data);

// Only in fields a K3 has.
CamFieldSet differences(const CamProgram &a, const CamProgram &b);

} // namespace codewheel
