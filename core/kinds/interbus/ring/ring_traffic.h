// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "catalog/device_description.h"
#include "vocabulary/exchange.h"

#include <array>
#include <memory>

namespace codewheel {

inline constexpr std::array ringTrafficColumns{
    TrafficColumn::time, TrafficColumn::sinceLast, TrafficColumn::cycle,  TrafficColumn::out,
    TrafficColumn::in,   TrafficColumn::meaning,   TrafficColumn::remark,
};

// Makes the rows of one encoder, one after the other.
class RingTraffic
{
public:
    explicit RingTraffic(const DeviceDescription &device)
        : m_device(std::make_shared<const DeviceDescription>(device))
    {}

    TrafficRow row(Place place, const Exchange &exchange);

private:
    std::shared_ptr<const DeviceDescription> m_device; // rows outlive the session
    std::optional<Exchange> m_last;
};

} // namespace codewheel
