// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

namespace codewheel {

// Whether an encoder of the profile has parameters that this program can write or read.
bool hasParameters(Profile profile);

// What the row of a parameter must be like so that the words sent for it are right: a range that fits the
// data field, the words and commands the protocol has for it (docs/device-descriptions.md, "What belongs
// together"). Reports what breaks a rule to the row; used by the description reader.
void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                    const DeviceDescription &device);

} // namespace codewheel
