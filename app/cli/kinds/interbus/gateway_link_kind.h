// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/interbus/gateway_access.h"
#include "cli/kinds/link_kind.h"

namespace codewheel {

extern const Subcommand gatewayCommand;

std::unique_ptr<const LinkKind> gatewayLinkKind();

// A ring behind a gateway, as the project plans it; null: there is no project.
MakeLink ringBehind(const GatewaySettings &gateway, const Project *project, BusId ring);

} // namespace codewheel
