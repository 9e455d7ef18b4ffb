// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/told_bus_names.h"

#include "journal/message_fields.h"
#include "vocabulary/bus_names.h"

#include <iterator>
#include <utility>

namespace codewheel {

// Kept only where a name is another than before, so that a million messages take no memory.
void ToldBusNames::note(BusId bus, qint64 at)
{
    Names now{nameAmongOthers(bus), Place{bus, {}}.shown()};
    if (const Names *before = namesAt(bus, at); before == nullptr || *before != now)
        m_names[bus].insert_or_assign(at, std::move(now));
}

QString ToldBusNames::placeName(const std::optional<Place> &place, qint64 at) const
{
    const Names *names = place ? namesAt(place->bus, at) : nullptr;
    if (names == nullptr)
        return codewheel::placeName(place);
    if (place->isEmpty())
        return names->ofBus.isEmpty() ? nameOfNamelessBus() : names->ofBus;
    return names->amongOthers.isEmpty() ? place->toString()
                                        : shownPlace(*place, {{place->bus, names->amongOthers}});
}

const ToldBusNames::Names *ToldBusNames::namesAt(BusId bus, qint64 at) const
{
    const auto its = m_names.find(bus);
    if (its == m_names.end())
        return nullptr;
    const auto later = its->second.upper_bound(at);
    return later == its->second.begin() ? nullptr : &std::prev(later)->second;
}

} // namespace codewheel
