// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

namespace codewheel {

// The name of a value in the user's language: "CW", "unsigned, CW". Empty where the value has none.
QString choiceName(const ParameterDescription &parameter, std::int64_t value);

// A value for the user, without its unit: "8 192", "3 (CW)", "21.5" for 215 tenths of a degree.
QString valueText(const ParameterDescription &parameter, std::int64_t value);

// The unit that goes with valueText(): "steps", "°C"; empty for none.
QString unitText(Unit unit);

} // namespace codewheel
