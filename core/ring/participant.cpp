// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/participant.h"

#include "catalog/device_description.h"

#include <QCoreApplication>

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

QString participantName(const Participant &participant, const DeviceDescription *description)
{
    if (description)
        return description->fullName();
    if (participant.idCode == busTerminalIdCode)
        return QCoreApplication::translate("Participant", "bus terminal");
    return QCoreApplication::translate("Participant", "device not known");
}

} // namespace codewheel
