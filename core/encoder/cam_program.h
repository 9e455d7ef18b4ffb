// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/known.h"

#include <array>
#include <cstdint>

namespace codewheel {

// One cam of a FRABA encoder (FRABA manual 5.4.4). It is on from start to stop, both included, compared with
// the unsigned position; start > stop goes through zero. Positions in steps, 0..total range - 1.
struct Cam
{
    std::int64_t start = 0;
    std::int64_t stop = 0;
    bool active = false;

    friend constexpr bool operator==(const Cam &, const Cam &) = default;
};

// One of the eight cam programs: eight cams, and what part of the position stands beside them in IN.
struct CamProgram
{
    static constexpr std::size_t cams = 8;  // 0..7
    static constexpr unsigned programs = 8; // 1..8
    static constexpr unsigned largestShift = 25;

    unsigned number = 1;
    std::array<Cam, cams> cam{};
    unsigned shift = 0; // shift_iw: IN D24..D8 = (position >> shift) & 1FFFFh; 25: cams only

    friend constexpr bool operator==(const CamProgram &, const CamProgram &) = default;
};

// A cam program the encoder is known to have.
struct KnownCams
{
    CamProgram program;
    Evidence evidence = Evidence::read;
    Instant at{};

    friend bool operator==(const KnownCams &, const KnownCams &) = default;
};

} // namespace codewheel
