// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <vector>

namespace codewheel {

struct NamedBus
{
    BusId id;
    QString kind; // "interbus"
    QString name;
};

// The names that tell buses with the same places apart: of every bus whose kind is there more than once.
std::map<BusId, QString> namesOfSeveral(const std::vector<NamedBus> &buses);

std::map<BusId, QString> namesOf(const std::vector<NamedBus> &buses);

// "1.0", or "Crane 2/1.0" where the bus has a name here.
QString shownPlace(Place place, const std::map<BusId, QString> &names);

} // namespace codewheel
