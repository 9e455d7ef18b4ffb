// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/numbering.h"

#include <algorithm>

namespace codewheel {

void numberDevices(RingStructure &structure)
{
    DeviceNumber number;
    for (RingDevice &participant : structure) {
        number = nextNumber(number, isOnLocalBus(participant));
        participant.number = number.node();
    }
}

// In ring order a line continues until a device of a lower level follows.
std::vector<std::size_t> placesBehindSegment(const RingStructure &ring, int segment)
{
    const auto first = std::ranges::find(ring, DeviceNumber{segment, 0}.node(), &RingDevice::number);
    std::vector<std::size_t> places;
    for (auto device = first; device != ring.end() && device->level >= first->level; ++device)
        places.push_back(static_cast<std::size_t>(device - ring.begin()));
    return places;
}

} // namespace codewheel
