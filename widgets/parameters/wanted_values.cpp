// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/wanted_values.h"

namespace codewheel {

std::optional<std::int64_t> WantedValues::value(DeviceNumber number, Parameter parameter) const
{
    return valueOf(values(number), parameter);
}

ParameterValues WantedValues::values(DeviceNumber number) const
{
    ParameterValues wanted;
    if (const auto device = m_values.find(number); device != m_values.end())
        for (const auto &[parameter, value] : device->second)
            wanted.push_back({parameter, value});
    return wanted;
}

void WantedValues::set(DeviceNumber number, Parameter parameter, std::optional<std::int64_t> value)
{
    if (this->value(number, parameter) == value)
        return;
    if (value)
        m_values[number][parameter] = *value;
    else
        m_values[number].erase(parameter);
    Q_EMIT changed(number);
}

void WantedValues::clear(DeviceNumber number)
{
    if (m_values.erase(number) != 0)
        Q_EMIT changed(number);
}

} // namespace codewheel
