// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/known.h"

#include <QDateTime>
#include <QString>

namespace codewheel::parameter_words {

// "The encoder told it when it was read. 02/03/2026 14:02"
QString howKnown(const std::optional<Known> &known, const QDateTime &when, bool reads);
// "Range: 1 to 4 096. Factory setting: 1."
QString rangeAndFactory(const ParameterDescription &parameter);

} // namespace codewheel::parameter_words
