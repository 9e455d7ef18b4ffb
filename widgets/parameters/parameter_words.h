// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

#include <QString>

namespace codewheel::parameter_words {

// "Range: 1 to 4 096. Factory setting: 1."
QString rangeAndFactory(const ParameterDescription &parameter);

} // namespace codewheel::parameter_words
