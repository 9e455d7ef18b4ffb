// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/frame_meaning.h"

namespace codewheel::canopen {

// Says what frames mean by the predefined connection set, "Node 5: TPDO1", and by what the nodes were heard
// to map: "Node 5: TPDO1, 6004h:0 = 1388h = 5000". Besides, it keeps which block transfers of SDO are under
// way.
FrameMeaning frameMeaning();

} // namespace codewheel::canopen
