// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/project_adapter.h"

#include "links/port_access.h"

namespace codewheel {

KeptAdapter keptAdapterOf(const ProjectLine &line)
{
    const QString path = portPath(line.wish.port);
    const LineAdapter &adapter = line.adapter;
    if (adapter == LineAdapter())
        return KeptAdapter(path);
    return KeptAdapter(PortInfo{.path = path,
                                .serialNumber = adapter.serialNumber,
                                .usbPath = adapter.usbPath,
                                .vendor = adapter.vendor,
                                .product = adapter.product});
}

LineAdapter adapterAt(const QString &port, const std::vector<PortInfo> &present)
{
    const std::optional<PortInfo> there = portAt(portPath(port), present);
    if (!there)
        return {};
    return {there->vendor, there->product, there->serialNumber, there->usbPath};
}

} // namespace codewheel
