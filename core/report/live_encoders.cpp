// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/live_encoders.h"

#include "ring/bus_session.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"

#include <algorithm>

namespace codewheel {
namespace {

bool isTold(const StoredValue &value)
{
    return value.evidence == Evidence::told;
}

} // namespace

std::vector<ConnectedEncoder> connectedEncoders(const Project &project, const BusSession &bus)
{
    std::vector<ConnectedEncoder> encoders;
    const ProjectPlaces places(project, bus);
    for (const ProjectDevice &planned : project.devices)
        if (places.isAtItsPlace(planned.place()))
            if (EncoderSession *encoder = bus.encoder(planned.place()))
                encoders.emplace_back(&planned, encoder);
    return encoders;
}

void addConnected(ReportInput &input, const BusSession &bus)
{
    input.connected = bus.structure();
    for (const auto &[planned, encoder] : connectedEncoders(input.project, bus)) {
        LiveEncoder known{valuesToStore(*encoder), camsToStore(*encoder)};
        if (!known.cams.empty() || !std::ranges::all_of(known.values, isTold))
            input.live[encoder->place()] = std::move(known);
        input.writes[encoder->place()] = encoder->eepromCount();
    }
}

} // namespace codewheel
