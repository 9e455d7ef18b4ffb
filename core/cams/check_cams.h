// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/cam_program.h"
#include "encoder/refusal.h"
#include "words/k3_word.h"

namespace codewheel {

// The largest position 25 bits hold: the limit where the total range is not known.
inline constexpr std::int64_t largestCamPosition = k3::largestTotalRange - 1;

// Whether there is such a program: 1..8 (camProgramOutOfRange).
Result<void> checkCamProgramNumber(std::int64_t number);

// Whether an encoder with positions 0..largestPosition can take the program, active or not
// (camProgramOutOfRange, camShiftOutOfRange, camPositionTooLarge).
Result<void> check(const CamProgram &program, std::int64_t largestPosition = largestCamPosition);

} // namespace codewheel
