// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/canopen/eds/device_file.h"

namespace codewheel::canopen {

// The objects that CiA 301 and CiA 406 (class 1 and 2) give an encoder, for a device without a file of its
// maker. No device has all of them. Their names are in English, as in any file.
DeviceFile standardObjects();

// In the user's language; empty: it is none of them.
QString standardObjectName(SdoObject object);

// The objects of a device without a file of its maker, with names in the user's language: those of CiA 301
// and CiA 406, and what the description of its make has of them and beyond. `device`: null if not known.
DeviceFile describedObjects(const DeviceDescription *device);

} // namespace codewheel::canopen
