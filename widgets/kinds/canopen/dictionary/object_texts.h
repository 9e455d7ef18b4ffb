// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/driver/wanted_objects.h"
#include "kinds/canopen/eds/device_file.h"

namespace codewheel {

// How objects of a node are shown.

// "1388h = 5000", "1.5", a text; what needs the number of the node, as the file has it.
QString objectValueText(const canopen::FileValue &value, std::optional<canopen::DataType> type);
// The same of what the project wants; of bits "bit 0 = 1, bit 2 = 0".
QString wantedObjectText(const canopen::WantedObject &wanted, std::optional<canopen::DataType> type);
// What the bits of a value say, an entry of a mapping, an identifier. Empty: it is just a number.
QString objectMeaningText(canopen::SdoObject object, const canopen::FileValue &value);
QString objectAccessText(std::optional<canopen::FileAccess> access);

} // namespace codewheel
