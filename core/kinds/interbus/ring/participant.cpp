// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/participant.h"

#include <algorithm>

namespace codewheel {

bool isSameRing(const RingStructure &ring, const RingStructure &other)
{
    const auto asMasterSees = [](Participant participant) {
        participant.deviceKey.clear();
        return participant;
    };
    return std::ranges::equal(ring, other, {}, asMasterSees, asMasterSees);
}

} // namespace codewheel
