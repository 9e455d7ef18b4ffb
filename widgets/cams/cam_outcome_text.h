// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/event.h"

#include <QString>

// What a job of the cam editor came to, in sentences.
namespace codewheel::cam_outcome {

QString programList(const std::vector<CamProgram> &programs); // "1, 2, 5"
// "Program 1 differs in cam 3, shift." Empty where it is the same.
QString difference(const CamProgram &wanted, const CamProgram &encoder);
QString readText(const Outcome &outcome);
QString writtenText(const Outcome &outcome);

} // namespace codewheel::cam_outcome
