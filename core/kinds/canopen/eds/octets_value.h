// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/file_value.h"
#include "kinds/canopen/protocol/octets.h"

namespace codewheel::canopen {

// What a device has answered for an object, as a device file has it: numbers by the sign of their type and
// the width of the answer, octets as hexadecimal digits.
FileValue fileValueOf(std::optional<DataType> type, Octets octets);

} // namespace codewheel::canopen
