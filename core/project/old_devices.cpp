// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/old_devices.h"

#include <algorithm>

namespace codewheel {

std::vector<OldDevices> oldDevices(const ConnectedBus &connected)
{
    std::vector<OldDevices> groups;
    for (const Participant &device : connected.devices) {
        const auto found = connected.notLive.find(device.number);
        if (found == connected.notLive.end())
            continue;
        const NotLive &old = found->second;
        const auto isItsReason = [&](const OldDevices &one) { return one.old.reason == old.reason; };
        auto group = std::ranges::find_if(groups, isItsReason);
        if (group == groups.end())
            group = groups.insert(groups.end(), {old});
        if (old.seen.isValid() && (!group->old.seen.isValid() || group->old.seen < old.seen))
            group->old.seen = old.seen;
        group->places << device.number.toString();
    }
    if (groups.size() == 1 && connected.notLive.size() == connected.devices.size())
        groups.front().places.clear();
    return groups;
}

QString withPlaces(const OldDevices &devices, const QString &sentence)
{
    return devices.places.isEmpty()
               ? sentence
               : QStringLiteral("%1: %2").arg(devices.places.join(QStringLiteral(", ")), sentence);
}

} // namespace codewheel
