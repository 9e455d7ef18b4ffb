// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/frame_meaning.h"

namespace codewheel::canopen {

// Says what frames mean by the predefined connection set: "Node 5: TPDO1". Of what came before it keeps only
// which block transfers of SDO are under way.
FrameMeaning frameMeaning();

} // namespace codewheel::canopen
