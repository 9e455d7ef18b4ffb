// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/snapshot.h"

namespace codewheel {

void Snapshot::giveWayTo(const Snapshot &newer)
{
    if (newer.generation != generation) {
        *this = newer;
        return;
    }
    static_cast<RingState &>(*this) = newer;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const Word outBefore = devices[i].outEdges;
        const Word inBefore = devices[i].inEdges;
        devices[i] = newer.devices[i];
        devices[i].outEdges |= outBefore;
        devices[i].inEdges |= inBefore;
    }
}

} // namespace codewheel
