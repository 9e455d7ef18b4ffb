// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/known.h"

#include <QDateTime>
#include <QString>

namespace codewheel::parameter_words {

// "8 192 steps", "3 (CW)"
QString withUnit(const ParameterDescription &parameter, std::int64_t value);
// "Steps = 255, Direction = 3 (CW)"
QString list(const DeviceDescription &device, const ParameterValues &values);
// "read", "echoed", "told"
QString evidence(Evidence evidence);
// "The encoder told it when it was read, on ..."
QString howKnown(const std::optional<Known> &known, const QDateTime &when);
// "1 to 4 096 revolutions. Factory setting: 1."
QString rangeAndFactory(const ParameterDescription &parameter);

} // namespace codewheel::parameter_words
