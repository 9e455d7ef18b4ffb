// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/described_node.h"

#include "kinds/canopen/protocol/canopen_profile.h"
#include "kinds/canopen/protocol/canopen_reach.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

bool namesProduct(const DeviceDescription &device)
{
    return device.profile == profile::cia406 && canopenDevice(device).vendor && canopenDevice(device).product;
}

// 0: it is another device; the higher, the better it fits.
int fit(const DeviceDescription &device, const ToldIdentity &node)
{
    constexpr unsigned majorShift = 16;
    if (!namesProduct(device))
        return 0;
    const CanopenDevice its = canopenDevice(device);
    const auto [vendor, product, revision, serial] = node;
    if (its.vendor != vendor || its.product != product)
        return 0;
    if (!its.revision)
        return 1;
    if (!revision || *revision >> majorShift != *its.revision >> majorShift)
        return 0;
    return *revision == *its.revision ? 3 : 2;
}

} // namespace

const DeviceDescription *describedNode(std::span<const DeviceDescription> devices, const ToldIdentity &node)
{
    const auto best = std::ranges::max_element(
        devices, {}, [&](const DeviceDescription &device) { return fit(device, node); });
    return best != devices.end() && fit(*best, node) > 0 ? &*best : nullptr;
}

bool describesNodes(std::span<const DeviceDescription> devices)
{
    return std::ranges::any_of(devices, namesProduct);
}

} // namespace codewheel::canopen
