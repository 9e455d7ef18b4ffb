// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

#include <QJsonArray>

namespace codewheel {

class EncoderSession;

// "= 8192", "= 21.5 °C". Steps and revolutions are their own units. options: valueText().
QString valueCell(const ParameterDescription &parameter, const Value &value, const KindData &options = {});
// What an encoder has, a line for each value; the version of a serial encoder last, if there is one.
QString valueLines(const EncoderSession &encoder, const ParameterValues &values, const QString &version = {});
// What the encoder sends as another number also as it was sent.
QJsonArray valuesJson(const EncoderSession &encoder, const ParameterValues &values);

} // namespace codewheel
