// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"

#include <QString>

namespace codewheel::canopen {

// What a frame says by the predefined connection set, in a short sentence: "Node 5: TPDO1". Empty: its
// identifier is not in there.
QString frameText(const CanFrame &frame);

} // namespace codewheel::canopen
