// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_snapshot.h"

#include "kinds/canopen/bus/canopen_bus_refusals.h"

#include <algorithm>

namespace codewheel {

std::optional<Refusal> whyHeldBack(const CanopenState &bus)
{
    if (!bus.isHeldBack())
        return std::nullopt;
    if (bus.onlyJ1939)
        return Refusal{RefusalKind::busy, CanopenBusRefusalId::onlyJ1939, {}};
    return Refusal{RefusalKind::busy, CanopenBusRefusalId::otherMaster, {bus.otherMaster.argument()}};
}

Result<void> maySend(const CanopenState &bus, const QString &place)
{
    if (!bus.connected)
        return tl::unexpected(
            bus.whyLost.value_or(Refusal{RefusalKind::link, CanopenBusRefusalId::closed, {}}));
    if (!bus.operate)
        return refuse(RefusalKind::busy, RefusalId::watchOnly,
                      place.isEmpty() ? std::vector<RefusalArgument>() : std::vector<RefusalArgument>{place});
    if (const auto held = whyHeldBack(bus))
        return tl::unexpected(*held);
    if (bus.scanning)
        return refuse(RefusalKind::busy, CanopenBusRefusalId::searching);
    return {};
}

Result<void> mayStart(const CanopenState &bus, const QString &place)
{
    if (bus.connected && !bus.running)
        return refuse(RefusalKind::busy, RefusalId::notRunning, {place});
    return maySend(bus, place);
}

} // namespace codewheel
