// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// For the list of kinds (buses.cpp): serial CAN adapters, which are asked at ports of USB devices only
// (ttyACM0), and at those that are named as an adapter.
std::unique_ptr<const SpokenProtocol> makeSlcanProtocol();

// Of the port, which those on USB do not care about.
SerialSettings usualSlcanSettings();
// Asks the adapter who it is, then listens at each rate until somebody is heard. Nothing is sent on the bus:
// it listens only, and one that cannot is not opened.
std::unique_ptr<Asking> askSlcanAdapter(const QString &port);

} // namespace codewheel
