// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/map_reading.h"

#include <algorithm>
#include <iterator>

namespace codewheel {
namespace {

// Empty: not all of its registers are there, or nothing in it can be judged.
std::optional<bool> fitsAll(const std::vector<CheckedDevice> &devices, const GatewaySettings &settings,
                            int first, std::span<const Register> registers)
{
    RingStructure ring;
    for (const CheckedDevice &device : devices)
        ring.push_back(device.participant);
    const auto map = GatewayMap::of(ring, settings);
    if (!map)
        return std::nullopt;
    std::optional<bool> fits;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const RegisterBlock &its = map->in(i);
        if (its.count < 2 || !devices[i].sender.device)
            continue;
        if (its.first < first || its.end() > first + static_cast<int>(registers.size()))
            return std::nullopt;
        const auto word = registers.subspan(static_cast<std::size_t>(its.first - first), 2);
        const auto readings = wordReadings(word, devices[i].sender);
        const WordReading *reading = readingIn(readings, wordOrderOf(settings.highWordFirst));
        fits = fits.value_or(true) && reading != nullptr && reading->plausibility == Plausibility::fits;
    }
    return fits;
}

} // namespace

MapReadings fittingMaps(const MapReadings &readings)
{
    MapReadings fitting;
    std::ranges::copy_if(readings, std::back_inserter(fitting), &MapReading::fits);
    return fitting;
}

MapReadings readMaps(const std::vector<CheckedDevice> &devices, const GatewaySettings &settings, int first,
                     std::span<const Register> registers)
{
    MapReadings readings;
    for (const int in : {settings.inFirst - 1, settings.inFirst, settings.inFirst + 1})
        for (const bool highWordFirst : {true, false}) {
            GatewaySettings moved = settings;
            moved.inFirst = in;
            moved.highWordFirst = highWordFirst;
            if (const auto fits = in < 0 ? std::nullopt : fitsAll(devices, moved, first, registers))
                readings.push_back({in, highWordFirst, *fits});
        }
    return readings;
}

} // namespace codewheel
