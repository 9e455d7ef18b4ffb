// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_device.h"

#include <algorithm>

namespace codewheel {
namespace {

// What only a ring knows of its devices.
struct RingDetails
{
    int inWords = 0;
    int outWords = 0;
    int level = 0;

    friend bool operator==(const RingDetails &, const RingDetails &) = default;
};

} // namespace

RingDevice::operator Participant() const
{
    const RingDetails details{inWords, outWords, level};
    return {number, deviceCode, deviceKey, details == RingDetails() ? KindData() : KindData(details)};
}

RingDevice ringDevice(const Participant &participant)
{
    const auto *given = participant.details.as<RingDetails>();
    const RingDetails details = given != nullptr ? *given : RingDetails();
    return {participant.number, participant.deviceCode, details.inWords,
            details.outWords,   participant.deviceKey,  details.level};
}

RingStructure ringStructure(std::span<const Participant> participants)
{
    RingStructure ring;
    ring.reserve(participants.size());
    std::ranges::transform(participants, std::back_inserter(ring), ringDevice);
    return ring;
}

std::vector<Participant> participantsOf(const RingStructure &ring)
{
    return {ring.begin(), ring.end()};
}

bool isSameRing(const RingStructure &ring, const RingStructure &other)
{
    const auto asMasterSees = [](RingDevice device) {
        device.deviceKey.clear();
        return device;
    };
    return std::ranges::equal(ring, other, {}, asMasterSees, asMasterSees);
}

} // namespace codewheel
