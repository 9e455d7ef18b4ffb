// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/plan/process_addresses.h"
#include "project/finding.h"

namespace codewheel {

// Limits and rules of the ring, a process image that cannot be in the registers of its gateway (at the first
// device), devices for a local bus on the remote bus, overlapping addresses, addresses
// that are not word-aligned, and, if the project asks for it, encoders that are not above P127 (Step 5; FRABA
// manual 4). In ring order.
std::vector<Finding> checkProject(const Project &project, const std::vector<DeviceAddresses> &addresses,
                                  BusId ring = firstBus);

} // namespace codewheel
