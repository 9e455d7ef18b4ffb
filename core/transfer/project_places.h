// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "vocabulary/refusal.h"

#include <map>
#include <optional>
#include <set>

namespace codewheel {

class Buses;
class EncoderBus;

// False if the bus is a simulated one in place of the project's, whose link is a real one.
bool isTheProjects(const Project &project, const EncoderBus &bus);

// Whether the device connected at a place is the one that the project has there, as its bus reports
// (EncoderBus::strangers, isOther). Everything that goes from a project to an encoder or back asks here:
// transfers, storing, replacing, restoring, the names of encoders, the report; in the window and at the
// command line.
class ProjectPlaces
{
public:
    ProjectPlaces(const Project &project, const Buses &buses);

    // Why it is not certain to be the project's device. Empty if it is, and if the project has no device
    // there.
    std::optional<Refusal> hindrance(Place place) const;
    // The same for one that replaces the project's device: it may have another name and another serial
    // number.
    std::optional<Refusal> hindranceToReplace(Place place) const;
    // Whether the project has a device there, and it is the connected one.
    bool isAtItsPlace(Place place) const { return m_places.contains(place) && !hindrance(place); }
    // False for a simulated one in place of the project's, whose link is a real one: nothing of that is kept
    // or reported.
    bool isTheProjects(Place place) const;

private:
    struct Standing
    {
        std::optional<Refusal> asStranger; // what is connected at the place is not where the plan has it
        std::optional<Refusal> asOther;    // it is, but it is a different one
    };

    std::map<Place, Standing> m_places;
    std::set<BusId> m_simulated; // simulated ones in place of buses with real links
};

} // namespace codewheel
