// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/frame_meaning.h"
#include "kinds/canopen/protocol/lss.h"
#include "kinds/canopen/protocol/sdo.h"

namespace codewheel::canopen {

// Says what frames mean by the predefined connection set, "Node 5: TPDO1", and by what the nodes were heard
// to map: "Node 5: TPDO1, 6004h:0 = 1388h = 5000". Besides, it keeps which block transfers of SDO are under
// way.
FrameMeaning frameMeaning();

// "node number 5", "store"
QString lssRequestText(const LssFrame &lss);
// "node number taken", "vendor 10Dh"
QString lssAnswerText(const LssFrame &lss);

// "read 6004h:0", "6004h:0 = 1388h = 5000", "6003h:0 written", "6004h:1 aborted, 06090011h: There is no such
// subindex."
QString sdoText(const SdoFrame &sdo);

} // namespace codewheel::canopen
