// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/can_interface.h"
#include "widgets/kinds/canopen/can_interface_row.h"

namespace codewheel {

// The CAN interfaces as listed in the settings form: what the system tells of each, and the command that
// helps where it is switched off, has left the bus, or does not only listen.
CanInterfaceRows canInterfaceRows(const std::vector<CanInterface> &interfaces);
// One row for each, for support; in English.
QStringList canAdapterRows();

} // namespace codewheel
