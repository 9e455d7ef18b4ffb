// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/live_encoders.h"

#include "bus/buses.h"
#include "jobs/values_to_write.h"
#include "project/plan_rules.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"

#include <algorithm>

namespace codewheel {
namespace {

std::map<Parameter, Kept> keptBy(const EncoderSession &encoder)
{
    std::map<Parameter, Kept> kept;
    for (const Known &known : allKnown(encoder))
        kept[known.parameter] = known.kept;
    return kept;
}

bool isTold(const StoredValue &value)
{
    return value.evidence == Evidence::told;
}

} // namespace

std::vector<ConnectedEncoder> connectedEncoders(const Project &project, const Buses &buses)
{
    std::vector<ConnectedEncoder> encoders;
    const ProjectPlaces places(project, buses);
    for (const ProjectDevice &planned : project.devices)
        if (places.isTheProjects(planned.place()))
            if (EncoderSession *encoder = buses.encoder(planned.place()))
                encoders.emplace_back(&planned, encoder);
    return encoders;
}

void addConnected(ReportInput &input, const Buses &buses)
{
    for (const EncoderBus *bus : buses.open())
        if (bus->findsDevices() && // otherwise it shows those it was told
            findBus(input.project, bus->id()) != nullptr && isTheProjects(input.project, *bus))
            input.connected.emplace(bus->id(), connectedBus(input.project, *bus));
    for (const auto &[planned, encoder] : connectedEncoders(input.project, buses)) {
        const EncoderBus &bus = *buses.busOf(encoder->place());
        LiveEncoder known{valuesToStore(*encoder), camsToStore(*encoder), notLive(bus, encoder->place()),
                          bus.isSimulated(), keptBy(*encoder)};
        if (!known.cams.empty() || !std::ranges::all_of(known.values, isTold))
            input.live[encoder->place()] = std::move(known);
        input.writes[encoder->place()] = encoder->eepromCount();
    }
}

} // namespace codewheel
