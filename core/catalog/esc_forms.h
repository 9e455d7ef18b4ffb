// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// How a value of an encoder on a serial line is told where it is no plain number: "C000h (standstill,
// position warning)" bit by bit, "0012D503" of a serial number, "05h (5)" of its address; where the options
// are given, the scaling factor as a fraction too: "1F400000h (0.9765625)", and warnings also as they were
// sent. Null: a number.
const ValueForm *escForm(Parameter parameter);

} // namespace codewheel
