// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/complaint.h"
#include "modbus/gateway_settings.h"

#include <QStringList>

#include <vector>

namespace codewheel {

// Where to look for encoders.
struct FinderPlaces
{
    QStringList ports{}; // paths
    std::vector<GatewaySettings> hosts{};
};

// As typed: a port is a path, or a name below /dev; everything else is HOST[:PORT]. Nothing typed: every
// serial port there is.
Checked<FinderPlaces> finderPlaces(const QStringList &typed);

} // namespace codewheel
