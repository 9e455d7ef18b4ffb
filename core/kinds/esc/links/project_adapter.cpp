// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/links/project_adapter.h"

#include "links/port_access.h"

namespace codewheel {

KeptAdapter keptAdapterOf(const EscLinePlan &line)
{
    const QString path = portPath(line.settings.port);
    const EscLineAdapter &adapter = line.adapter;
    if (adapter == EscLineAdapter())
        return KeptAdapter(path);
    return KeptAdapter(PortInfo{.path = path,
                                .serialNumber = adapter.serialNumber,
                                .usbPath = adapter.usbPath,
                                .vendor = adapter.vendor,
                                .product = adapter.product});
}

EscLineAdapter lineAdapter(const std::optional<PortInfo> &adapter)
{
    if (!adapter)
        return {};
    return {adapter->vendor, adapter->product, adapter->serialNumber, adapter->usbPath};
}

} // namespace codewheel
