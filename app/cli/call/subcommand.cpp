// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/subcommand.h"

#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"

#include <algorithm>

namespace codewheel {

BusAccess *Call::findBus(BusId bus) const
{
    const auto found = std::ranges::find(links, bus, [](const BusAccess *link) { return link->bus().id(); });
    return found == links.end() ? nullptr : *found;
}

BusAccess &Call::busOf(Place place) const
{
    return *findBus(place.bus);
}

} // namespace codewheel
