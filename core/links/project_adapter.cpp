// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/project_adapter.h"

#include "links/port_access.h"

namespace codewheel {

KeptAdapter keptAdapterOf(const LinePlan &line)
{
    const QString path = portPath(line.settings.port);
    const LineAdapter &adapter = line.adapter;
    if (adapter == LineAdapter())
        return KeptAdapter(path);
    return KeptAdapter(PortInfo{.path = path,
                                .serialNumber = adapter.serialNumber,
                                .usbPath = adapter.usbPath,
                                .vendor = adapter.vendor,
                                .product = adapter.product});
}

LineAdapter lineAdapter(const std::optional<PortInfo> &adapter)
{
    if (!adapter)
        return {};
    return {adapter->vendor, adapter->product, adapter->serialNumber, adapter->usbPath};
}

} // namespace codewheel
