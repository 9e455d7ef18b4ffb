// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"
#include "vocabulary/refusal.h"

#include <vector>

namespace codewheel {

// The largest position 25 bits hold: the limit where the total range is not known.
inline constexpr std::int64_t largestCamPosition = (std::int64_t{1} << 25) - 1;

// All programs: 1 and up.
std::vector<unsigned> programNumbers(const CamAbilities &abilities);

// Whether there is such a program (camProgramOutOfRange).
Result<void> checkCamProgramNumber(std::int64_t number, const CamAbilities &abilities = {});

// Whether an encoder with these cams and positions 0..largestPosition can take the program or the cam, active
// or not (camProgramOutOfRange, camShiftOutOfRange, camHasNoShift, camOutOfRange, camPositionTooLarge,
// camThroughZero, camHasMore).
Result<void> check(const CamProgram &program, const CamAbilities &abilities,
                   std::int64_t largestPosition = largestCamPosition);
Result<void> check(const Cam &cam, std::size_t number, const CamAbilities &abilities,
                   std::int64_t largestPosition);

} // namespace codewheel
