// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/make_driver.h"

#include "catalog/protocol_rules.h"
#include "kinds/interbus/k3/k3_driver.h"
#include "kinds/interbus/la66/la66_driver.h"
#include "kinds/interbus/position/position_driver.h"
#include "kinds/interbus/words/profiles.h"

namespace codewheel {

std::unique_ptr<CyclicDriver> makeDriver(const DeviceDescription &device)
{
    if (device.profile == profile::k3)
        return std::make_unique<K3Driver>(device);
    if (device.profile == profile::la66)
        return std::make_unique<La66Driver>(device);
    if (onlyTellsPosition(device))
        return std::make_unique<PositionDriver>(device);
    return nullptr;
}

std::optional<Reading> readingOfWords(const DeviceDescription &device, const std::vector<Known> &known,
                                      Word in, Word out, Instant at)
{
    const auto driver = makeDriver(device);
    if (driver == nullptr)
        return std::nullopt;
    driver->setKnown(known);
    driver->cycle(in, out, at);
    return driver->reading();
}

} // namespace codewheel
