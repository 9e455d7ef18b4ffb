// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/words/device_number.h"

#include <cstddef>

namespace codewheel {

// Whether it is on the local bus behind a bus terminal (n.1, n.2, ...) rather than on the remote bus.
inline bool isOnLocalBus(const RingDevice &participant)
{
    return DeviceNumber::of(participant.number).position > 0;
}

// The number of the device that follows `before` in ring order: a remote-bus device starts a segment, one on
// the local bus counts on within it.
constexpr DeviceNumber nextNumber(DeviceNumber before, bool onLocalBus)
{
    return onLocalBus ? DeviceNumber{before.segment, before.position + 1}
                      : DeviceNumber{before.segment + 1, 0};
}

// Gives each device the number that follows from its place in the ring.
void numberDevices(RingStructure &structure);

// The devices, by their indices in ring order, that take no part in the data cycles while a segment is off:
// its remote-bus device with its local bus, and all that follow on that line with their branches. Empty:
// there is no such segment.
std::vector<std::size_t> placesBehindSegment(const RingStructure &ring, int segment);

} // namespace codewheel
