// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/value_tap.h"

namespace codewheel {

// Sorts what was shown on a bus by device, frame after frame in the same memory.
class ValueRound
{
public:
    // `isWhole`: false where some that came later were dropped: then no device shows anything behind them.
    const std::vector<ShownSeries> &sort(const std::vector<DeviceValues> &shown, bool isWhole)
    {
        for (ShownSeries &ofDevice : m_byDevice)
            ofDevice.clear();
        for (const DeviceValues &position : shown) {
            if (position.device >= m_byDevice.size())
                m_byDevice.resize(position.device + 1);
            m_byDevice[position.device].push_back(position.shown);
        }
        if (!isWhole && !shown.empty())
            for (ShownSeries &ofDevice : m_byDevice)
                ofDevice.push_back({.at = shown.back().shown.at});
        return m_byDevice;
    }

private:
    std::vector<ShownSeries> m_byDevice;
};

} // namespace codewheel
