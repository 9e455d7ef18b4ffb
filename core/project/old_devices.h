// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/plan_rules.h"

#include <QStringList>

namespace codewheel {

// Devices of a connected bus that are compared as they were, for one reason.
struct OldDevices
{
    NotLive old;          // seen: the newest of them
    QStringList places{}; // empty: all there are
};

// One for each reason, in the order of the bus; none: all are live.
std::vector<OldDevices> oldDevices(const ConnectedBus &connected);

// "3.0, 4.0: The device is not on the bus."; `sentence` tells the reason.
QString withPlaces(const OldDevices &devices, const QString &sentence);

} // namespace codewheel
