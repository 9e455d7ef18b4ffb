// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/value.h"

#include <QJsonValue>

namespace codewheel {

inline QJsonValue valueToJson(const Value &value)
{
    return value.isText() ? QJsonValue(value.toString()) : QJsonValue(qint64{value.number()});
}

// Empty if it is neither a number nor a text.
inline std::optional<Value> valueFromJson(const QJsonValue &json)
{
    if (json.isString())
        return Value(json.toString());
    return json.isDouble() ? std::optional<Value>(json.toInteger()) : std::nullopt;
}

} // namespace codewheel
