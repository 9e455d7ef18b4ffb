// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/known.h"

namespace codewheel {

// A value as it can be typed in again, with the number behind a name: "8192", "cw (3)".
QString typedValue(const ParameterDescription &parameter, std::int64_t value);
// "1..33554431", "cw (3), ccw (4)"; the same in every language
QString rangeText(const ParameterDescription &parameter);
// "read from the encoder"
QString evidenceText(Evidence evidence);

} // namespace codewheel
