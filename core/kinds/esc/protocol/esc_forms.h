// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// What the values of an encoder on a serial line leave open and a setting decides.
struct EscValueOptions
{
    bool swapsWarningBytes = false;
    int fractionBits = 0; // of the scaling factor

    friend bool operator==(const EscValueOptions &, const EscValueOptions &) = default;
};

// How a value of an encoder on a serial line is written if it is not a plain number: "C000h (standstill,
// position warning)" bit by bit, "0012D503" for a serial number, "05h (5)" for its address; with the options
// given, the scaling factor also as a fraction: "1F400000h (0.9765625)", and warnings also as they were sent.
// Null: a number.
const ValueForm *escForm(Parameter parameter);

} // namespace codewheel
