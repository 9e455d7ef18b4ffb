// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/file_layout.h"

namespace codewheel::canopen {

// Versions, who the device is, its node and its rate.
void readHead(const FileLayout &layout, DeviceFile &file);
// What the head does not say of the identity, 1018h may.
void completeIdentity(DeviceFile &file);

} // namespace codewheel::canopen
