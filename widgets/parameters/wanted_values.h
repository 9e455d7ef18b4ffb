// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/device_number.h"
#include "encoder/parameter.h"

#include <QObject>

#include <map>
#include <optional>

namespace codewheel {

// What the user wants each encoder to have: typed, not sent. Parameter panel and wizard share it.
class WantedValues : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    std::optional<std::int64_t> value(DeviceNumber number, Parameter parameter) const;
    ParameterValues values(DeviceNumber number) const; // in the order of the parameters
    // Nothing: leave it as it is.
    void set(DeviceNumber number, Parameter parameter, std::optional<std::int64_t> value);
    void clear(DeviceNumber number);

Q_SIGNALS:
    void changed(codewheel::DeviceNumber number);

private:
    std::map<DeviceNumber, std::map<Parameter, std::int64_t>> m_values;
};

} // namespace codewheel
