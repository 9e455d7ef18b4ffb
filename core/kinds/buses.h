// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/spoken_protocol.h"
#include "project/bus_kind.h"
#include "replay/recorded_rows.h"

#include <memory>
#include <vector>

namespace codewheel {

// What the core has of every kind of bus: another kind has a row in each list of buses.cpp.
std::vector<std::unique_ptr<const BusKind>> builtInBusKinds();
std::vector<std::unique_ptr<const SpokenProtocol>> builtInSpokenProtocols();
std::unique_ptr<RecordedRows> rowsWithoutProfile(bool hasWords); // of words, or of bytes

} // namespace codewheel
