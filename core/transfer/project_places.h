// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"
#include "project/project.h"

#include <map>
#include <optional>
#include <set>

namespace codewheel {

class Buses;
class EncoderBus;

// Whether the bus is no simulated one in the place of the project's, whose link is a real one.
bool isTheProjects(const Project &project, const EncoderBus &bus);

// Whether the device that is connected at a place is the one that the project has there, as its bus tells
// (EncoderBus::strangers, isOther). Everything that goes from a project to an encoder or back asks here:
// transfers, storing, replacing, restoring, the names of encoders, the report; in the window and at the
// command line.
class ProjectPlaces
{
public:
    ProjectPlaces(const Project &project, const Buses &buses);

    // Why it is not for certain the project's device. Nothing where it is, and where the project has no
    // device.
    std::optional<Refusal> hindrance(Place place) const;
    // The same for one that takes the place of the project's device: it may be named otherwise, and tell
    // another serial number.
    std::optional<Refusal> hindranceToReplace(Place place) const;
    // Whether the project has a device there, and it is the connected one.
    bool isAtItsPlace(Place place) const;
    // Whether it is no simulated one in the place of the project's, whose link is a real one: of that nothing
    // is kept, nor reported.
    bool isTheProjects(Place place) const;

private:
    struct Standing
    {
        std::optional<Refusal> asStranger; // what is connected at the place is not where the plan has it
        std::optional<Refusal> asOther;    // it is, and is another one
    };

    std::map<Place, Standing> m_places;
    std::set<BusId> m_simulated; // the buses of real links
};

} // namespace codewheel
