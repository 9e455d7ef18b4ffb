// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/live_encoders.h"

#include "bus/buses.h"
#include "project/ring_plan.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isTold(const StoredValue &value)
{
    return value.evidence == Evidence::told;
}

// A ring as a whole, of any other kind what is not connected as planned.
void addBus(ReportInput &input, const EncoderBus &bus, const ProjectPlaces &places)
{
    const PlannedBus *planned = findBus(input.project, bus.id());
    if (planned == nullptr)
        return;
    if (planned->settings.as<RingPlan>()) {
        input.connected.emplace();
        for (const Place place : bus.places())
            input.connected->push_back(*bus.found(place));
        return;
    }
    for (const ProjectDevice &device : devicesOn(input.project, bus.id())) {
        if (!input.strangers)
            input.strangers.emplace();
        if (auto why = places.hindrance(device.place()))
            input.strangers->push_back(std::move(*why));
    }
}

} // namespace

std::vector<ConnectedEncoder> connectedEncoders(const Project &project, const Buses &buses)
{
    std::vector<ConnectedEncoder> encoders;
    const ProjectPlaces places(project, buses);
    for (const ProjectDevice &planned : project.devices)
        if (places.isAtItsPlace(planned.place()))
            if (EncoderSession *encoder = buses.encoder(planned.place()))
                encoders.emplace_back(&planned, encoder);
    return encoders;
}

void addConnected(ReportInput &input, const Buses &buses)
{
    for (const EncoderBus *bus : buses.open())
        addBus(input, *bus, ProjectPlaces(input.project, buses));
    for (const auto &[planned, encoder] : connectedEncoders(input.project, buses)) {
        LiveEncoder known{valuesToStore(*encoder), camsToStore(*encoder)};
        if (!known.cams.empty() || !std::ranges::all_of(known.values, isTold))
            input.live[encoder->place()] = std::move(known);
        input.writes[encoder->place()] = encoder->eepromCount();
    }
}

} // namespace codewheel
