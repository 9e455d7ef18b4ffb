// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/send_permission.h"

namespace codewheel {

Result<void> maySend(const Snapshot &ring, std::size_t device, const QString &place, RefusalCode whenHeld)
{
    const auto notNow = [&place](RefusalCode why) { return refuse(RefusalKind::busy, why, {place}); };
    if (!ring.connected && ring.whyLost)
        return tl::unexpected(*ring.whyLost);
    if (ring.state != MasterState::run)
        return notNow(RefusalId::notRunning);
    if (ring.told && ring.told->stands()) // in Watch, too: Operate would not help
        return tl::unexpected(ring.told->whyItStands());
    if (!ring.operate)
        return notNow(RefusalId::watchOnly);
    if (!ring.devices[device].inRing)
        return tl::unexpected(ring.whyOutOfSight(device, place));
    if (ring.devices[device].heldByJob)
        return notNow(whenHeld);
    return {};
}

Result<void> mayChangeRing(const Snapshot &ring)
{
    return ring.operate ? Result<void>() : refuse(RefusalKind::busy, RefusalId::watchOnly);
}

} // namespace codewheel
