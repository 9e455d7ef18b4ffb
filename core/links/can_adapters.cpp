// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/can_adapters.h"

#include <algorithm>

namespace codewheel {

CanAdapters canAdapters(const std::vector<PortInfo> &ports, const Computer &computer,
                        const CanStatusOf &statusOf)
{
    CanAdapters found{.interfaces = canInterfaces(computer, statusOf)};
    std::ranges::copy_if(ports, std::back_inserter(found.ports), &PortInfo::isUsb);
    return found;
}

} // namespace codewheel
