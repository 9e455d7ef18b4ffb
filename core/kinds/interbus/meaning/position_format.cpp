// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/meaning/position_format.h"

#include "catalog/total_range.h"
#include "kinds/interbus/words/profiles.h"

#include <algorithm>
#include <bit>

namespace codewheel {
namespace {

// 13 bits for the turn and 12 for the turns (FRABA manual 8), the most any K2 is known to have.
constexpr int mostK2Bits = 25;

} // namespace

PositionWord positionFormat(const DeviceDescription &device)
{
    PositionWord format;
    const int bits = device.profile == profile::k1 ? 16 : 32;
    format.positionBits = device.profile == profile::k2 ? mostK2Bits : bits;
    format.coding = device.coding;
    format.hasStatusBits = device.profile == profile::k4;
    format.hasOut = device.profile == profile::k4;
    const auto range = static_cast<std::uint64_t>(physicalRange(device));
    if (range > 0 && !format.hasStatusBits)
        format.positionBits = std::clamp(static_cast<int>(std::bit_width(range - 1)), 1, bits);
    return format;
}

} // namespace codewheel
