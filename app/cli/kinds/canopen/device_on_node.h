// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/places.h"
#include "kinds/canopen/protocol/described_node.h"
#include "kinds/canopen/protocol/device_of_type.h"

namespace codewheel {

// As its identity (1018h) is described, or else by its device type (1000h) the form of encoder that CiA 406
// has there. Empty: it is none of these.
QString deviceOfNode(const Catalog &catalog, std::optional<std::uint32_t> deviceType,
                     const canopen::ToldIdentity &identity);

// The device that --device names, or else that of the project; empty: nobody has named it.
Checked<QString> deviceOnNode(const Call &call, Place place);

} // namespace codewheel
