// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/known.h"

#include <array>
#include <cstdint>

namespace codewheel {

// One cam: on from start to stop, both included, compared with the unsigned position; where the positions
// form a circle, start > stop goes through zero (FRABA manual 5.4.4). Positions in steps, 0..total range - 1.
struct Cam
{
    std::int64_t start = 0; // the lower limit
    std::int64_t stop = 0;  // the upper one
    bool active = false;
    std::int64_t hysteresis = 0; // steps past an edge before the cam switches back
    bool isInverted = false;     // polarity: on outside start..stop

    friend constexpr bool operator==(const Cam &, const Cam &) = default;
};

// A cam program: its cams, and which part of the position is shown beside them in IN.
struct CamProgram
{
    // The most any encoder has; CamAbilities says how many of them an encoder has.
    static constexpr std::size_t cams = 8;  // 0..7
    static constexpr unsigned programs = 8; // 1..8
    static constexpr unsigned largestShift = 25;

    unsigned number = 1;
    std::array<Cam, cams> cam{};
    unsigned shift = 0; // shift_iw: IN D24..D8 = (position >> shift) & 1FFFFh; 25: cams only

    friend constexpr bool operator==(const CamProgram &, const CamProgram &) = default;
};

// What cams a kind of encoder has. The defaults are those of a K3.
struct CamAbilities
{
    unsigned programs = CamProgram::programs;
    std::size_t cams = CamProgram::cams; // of each program
    bool isCyclic = true;                // the positions form a circle: a cam may go through zero
    bool hasMode = true;                 // a mode of its own: cams are shown and written in no other
    bool hasShift = true;                // a part of the position is shown beside the cams
    bool hasHysteresis = false;
    bool hasPolarity = false;

    friend constexpr bool operator==(const CamAbilities &, const CamAbilities &) = default;
};

// A cam program the encoder is known to have.
struct KnownCams
{
    CamProgram program;
    Evidence evidence = Evidence::read;
    Instant at{};

    friend bool operator==(const KnownCams &, const KnownCams &) = default;
};

inline std::vector<unsigned> numbersOf(const std::vector<CamProgram> &programs)
{
    std::vector<unsigned> numbers;
    numbers.reserve(programs.size());
    for (const CamProgram &program : programs)
        numbers.push_back(program.number);
    return numbers;
}

} // namespace codewheel
