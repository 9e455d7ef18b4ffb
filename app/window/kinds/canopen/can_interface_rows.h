// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/connect/port_rows.h"
#include "finder/place_finder.h"
#include "links/can_interface.h"
#include "widgets/kinds/canopen/can_interface_row.h"

namespace codewheel {

// The CAN interfaces as listed in the settings form: what the system tells of each, and the command that
// helps where it is switched off, has left the bus, or does not only listen.
CanInterfaceRows canInterfaceRows(const std::vector<CanInterface> &interfaces);
// One row for each, for support; in English.
QStringList canAdapterRows();

// The same as listed by the page "Who is there?", with the worst of what keeps them from being listened to.
PortRows canInterfacesToHear(const std::vector<CanInterface> &interfaces);
PortRows canInterfacesToHear(); // those of this computer
// Listens at this interface; null: there is none of this name.
std::unique_ptr<PlaceFinder> canInterfaceFinder(const QString &interface);

} // namespace codewheel
