// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"

#include <QStringList>

namespace codewheel {

struct DeviceDescription;
struct ValueForm;

namespace canopen {

// What the bits of an object say, the highest first: 6000h and 6500h, 6503h and 6504h, 6505h and 6506h,
// 6400h. Of the maker's bits, and of those that CiA 406 does not name, only the number. Empty: nothing.
QStringList encoderBitTexts(std::uint16_t index, std::uint32_t bits);
// The same, by the names that the description has for single bits.
QStringList encoderBitTexts(const DeviceDescription &device, std::uint16_t index, std::uint32_t bits);

// How the value of such an object is shown, "0005h (scaling on, CCW)", and that of 6507h and 6508h. Null: it
// is a plain number.
const ValueForm *encoderValueForm(std::uint16_t index);

} // namespace canopen
} // namespace codewheel
