// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"

namespace codewheel {

// For the list of kinds (buses.cpp): serial CAN adapters, which are asked at ports of USB devices only
// (ttyACM0).
std::unique_ptr<const SpokenProtocol> makeSlcanProtocol();

} // namespace codewheel
