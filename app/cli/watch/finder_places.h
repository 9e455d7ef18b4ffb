// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/kinds/link_kind.h"

#include <QStringList>

namespace codewheel {

// Where to look for encoders.
struct FinderPlaces
{
    QStringList ports{}; // paths
    std::vector<HostSearch> hosts{};
    std::vector<std::unique_ptr<PlaceFinder>> listeners{}; // they only listen
};

// As typed: a port is a path, or a name below /dev; everything else is a host, for every kind of bus that may
// be at one. Nothing typed: every serial port there is. A link is refused: its kind is what is looked for.
Checked<FinderPlaces> finderPlaces(const QStringList &typed);

} // namespace codewheel
