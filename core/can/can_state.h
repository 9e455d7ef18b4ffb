// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

namespace codewheel {

QString canStateKey(CanState state);  // language-neutral: "busOff"
QString canStateText(CanState state); // "bus off"

// "125", "83.3": kBit/s, of a rate in Bd.
QString inKilobits(int rate);

} // namespace codewheel
