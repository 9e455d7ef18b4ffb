// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/bus_names.h"

#include <algorithm>

namespace codewheel {

std::map<BusId, QString> namesOfSeveral(const std::vector<NamedBus> &buses)
{
    std::map<BusId, QString> names;
    for (const NamedBus &bus : buses)
        if (std::ranges::count(buses, bus.kind, &NamedBus::kind) > 1)
            names[bus.id] = bus.name;
    return names;
}

std::map<BusId, QString> namesOf(const std::vector<NamedBus> &buses)
{
    std::map<BusId, QString> names;
    for (const NamedBus &bus : buses)
        names[bus.id] = bus.name;
    return names;
}

QString shownPlace(Place place, const std::map<BusId, QString> &names)
{
    const auto name = names.find(place.bus);
    return name == names.end() ? place.toString()
                               : QStringLiteral("%1/%2").arg(name->second, place.toString());
}

} // namespace codewheel
