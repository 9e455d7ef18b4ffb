// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/device_file.h"

namespace codewheel::canopen {

// The objects that CiA 301 and CiA 406 (class 1 and 2) give an encoder, for a device without a file of its
// maker. No device has all of them. Their names are in English, as in any file.
DeviceFile standardObjects();

// In the user's language; empty: it is none of them.
QString standardObjectName(SdoObject object);

} // namespace codewheel::canopen
