// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/told_ring.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_refusals.h"

namespace codewheel {

Refusal ToldRing::whyItStands() const
{
    constexpr int statusDigits = 4;
    const QString shown = hexCode(status, statusDigits);
    if (!hasFailed)
        return {RefusalKind::link, GatewayRefusalId::ringStands, {shown}};
    const auto where = place ? faultPlaceOf(*place) : std::nullopt;
    if (!where)
        return {RefusalKind::link, GatewayRefusalId::ringFailed, {shown}};
    return {RefusalKind::link, GatewayRefusalId::ringFailedAt, {shown, faultPlaceText(*where)}};
}

} // namespace codewheel
