// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "project/process_addresses.h"

#include <cstddef>

namespace codewheel {

// Something that is wrong with a planned bus, as it is shown while it is edited.
struct Finding
{
    Severity severity = Severity::fault;
    std::size_t device = 0; // its place in the ring
    QString text;           // a sentence in the user's language

    friend bool operator==(const Finding &, const Finding &) = default;
};

// Limits and rules of the ring, devices of a local bus on the remote bus, overlaps of addresses, addresses
// that are not word aligned, and, where the project asks for it, encoders that do not stand above P127 (Step
// 5; FRABA manual 4). In ring order.
std::vector<Finding> checkProject(const Project &project, BusId ring = firstRing);
std::vector<Finding> checkProject(const Project &project, const std::vector<DeviceAddresses> &addresses,
                                  BusId ring = firstRing);

} // namespace codewheel
