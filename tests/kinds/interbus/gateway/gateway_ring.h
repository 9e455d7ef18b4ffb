// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/words/device_number.h"
#include "kinds/interbus/words/profiles.h"
#include "tests/support/register_bank.h"

namespace codewheel::test {

inline GatewayDevice k3At(int segment)
{
    return {{DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, {}}, profile::k3};
}
inline RingDevice frabaAt(int segment)
{
    return {DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")};
}
inline GatewayDevice deviceAt(int segment, int inWords, int outWords)
{
    return {{DeviceNumber{segment, 0}.node(), 0x0033, inWords, outWords, {}}, std::nullopt};
}
inline std::vector<GatewayDevice> k3Ring(int devices)
{
    std::vector<GatewayDevice> ring;
    for (int i = 1; i <= devices; ++i)
        ring.push_back(k3At(i));
    return ring;
}
inline RingStructure structureOf(const std::vector<GatewayDevice> &ring)
{
    RingStructure structure;
    for (const GatewayDevice &device : ring)
        structure.push_back(device.participant);
    return structure;
}

} // namespace codewheel::test
