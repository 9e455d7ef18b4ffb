// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "project/project.h"

#include <optional>

namespace codewheel {

class Catalog;

// The gateway by which the project reaches this ring; empty: it has another link.
std::optional<Result<GatewaySettings>> plannedGateway(const Project &project, BusId ring);

// The ring behind a gateway, as planned: a gateway has no ID cycle.
std::vector<GatewayDevice> gatewayDevices(const Project &project, BusId ring, const Catalog &catalog);

// The same for GatewayCheck, with what the project knows of the encoders.
std::vector<CheckedDevice> checkedDevices(const Project &project, BusId ring, const Catalog &catalog);

} // namespace codewheel
