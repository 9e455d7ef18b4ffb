// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/interbus/gateway_access.h"
#include "cli/kinds/link_kind.h"

namespace codewheel {

extern const Subcommand gatewayCommand;
extern const Subcommand masterCommand;

// Offer simulated rings to Modbus clients: serve modbus-tcp, serve modbus-rtu.
std::span<const Service> modbusServices();

std::unique_ptr<const LinkKind> gatewayLinkKind();
std::unique_ptr<const LinkKind> ringLinkKind();

// A ring behind a gateway, as the project plans it; null: there is no project.
MakeLink ringBehind(const GatewaySettings &gateway, const Project *project, BusId ring);

} // namespace codewheel
