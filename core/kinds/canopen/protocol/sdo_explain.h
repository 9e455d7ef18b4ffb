// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"

namespace codewheel::canopen {

// "read 6004h:0", "6004h:0 = 1388h = 5000", "6003h:0 written", "6004h:1 aborted, 06090011h: There is no such
// subindex."
QString sdoText(const SdoFrame &sdo);

} // namespace codewheel::canopen
