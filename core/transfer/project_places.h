// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "project/project.h"

#include <map>
#include <optional>

namespace codewheel {

class BusSession;
class Catalog;

// Whether the device at a place of the bus is the one that the project has there. The number alone does not
// tell: where a device before them is missing or additional, all behind it have another number. Everything
// that goes from a project to an encoder or back asks here: transfers, storing, replacing, restoring, the
// names of encoders, the report; in the window and at the command line.
class ProjectPlaces
{
public:
    ProjectPlaces(const Project &project, const RingStructure &connected, const Catalog &catalog,
                  BusId bus = firstRing);
    ProjectPlaces(const Project &project, const BusSession &bus);

    // Why it is not for certain the project's device: notInRing, or ringDiffers, which tells where the
    // project's one stands now. Nothing where it is, and where the project has no device.
    std::optional<Refusal> hindrance(Place place) const;
    // Whether the project has a device there, and it is the connected one.
    bool isAtItsPlace(Place place) const;

private:
    std::map<Place, std::optional<Refusal>> m_places;
};

} // namespace codewheel
