// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

namespace codewheel {

// How the parts of a description must fit together so that the words sent to the encoder are right
// (docs/device-descriptions.md, "What belongs together"). Each reports violations to its object; used by the
// description reader once the values are read.

// Codes and words of the profile (FRABA manual 2.2).
void checkPlaceOnBus(const JsonObject &json, const DeviceDescription &device);
// What only some profiles and makes can do. Parameters must have been read.
void checkCapabilities(const JsonObject &json, const DeviceDescription &device);
// Parameters and capabilities must have been read.
void checkQuirks(const JsonObject &json, const DeviceDescription &device);

} // namespace codewheel
