// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_check.h"

namespace codewheel {

// A register map near the one that is set, and whether what is read could be words of the encoders there.
struct MapReading
{
    int in = 0; // first register of IN
    bool highWordFirst = true;
    bool fits = false;

    friend bool operator==(const MapReading &, const MapReading &) = default;
};

using MapReadings = std::vector<MapReading>;
MapReadings fittingMaps(const MapReadings &readings);

// The maps that begin one register lower, where they are set, and one higher, in both word orders, as far as
// `registers`, which begin at `first`, hold all of them. Empty: no word of the ring can be judged.
MapReadings readMaps(const std::vector<CheckedDevice> &devices, const GatewaySettings &settings, int first,
                     std::span<const Register> registers);

} // namespace codewheel
