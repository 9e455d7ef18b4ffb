// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"

namespace codewheel {

// The description with the range that a line of these fraction bits leaves the scaling factor, which is
// 0.00001 to 1.0; all others as they are.
ParameterDescription atFractionBits(ParameterDescription parameter, int fractionBits);

// The name of a value in the user's language: "CW", "unsigned, CW". Empty where the value has none.
QString choiceName(const ParameterDescription &parameter, std::int64_t value);

// A value for the user, without its unit: "8 192", "3 (CW)", "21.5" for 215 tenths of a degree. Of a serial
// encoder what is no number is told by its hexadecimal digits: "C000h (standstill, position warning)" bit by
// bit, "0012D503" of a serial number, "05h (5)" of its address, and, where its options are given, the scaling
// factor as a fraction too: "1F400000h (0.9765625)", and warnings also as they were sent.
QString valueText(const ParameterDescription &parameter, std::int64_t value,
                  const std::optional<ValueOptions> &options = {});

// The unit that goes with valueText(): "steps", "°C"; empty for none.
QString unitText(Unit unit);

} // namespace codewheel
