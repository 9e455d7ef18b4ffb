// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/serial_ports.h"

#include <algorithm>

namespace codewheel {
namespace {

using Kind = AdapterMatch::Kind;

template <typename Condition>
std::vector<PortInfo> those(const std::vector<PortInfo> &ports, Condition condition)
{
    std::vector<PortInfo> chosen;
    std::ranges::copy_if(ports, std::back_inserter(chosen), condition);
    return chosen;
}

AdapterMatch matchOf(std::vector<PortInfo> ports)
{
    const Kind kind = ports.empty() ? Kind::absent : ports.size() == 1 ? Kind::found : Kind::ask;
    return {kind, std::move(ports)};
}

QString interfaceOf(const PortInfo &port)
{
    return port.usbPath.section(u':', 1);
}

// An adapter with several ports has one serial number for all of them.
AdapterMatch bySerialNumber(const PortInfo &wanted, const std::vector<PortInfo> &sameModel)
{
    auto same =
        those(sameModel, [&](const PortInfo &port) { return port.serialNumber == wanted.serialNumber; });
    const auto sameInterface =
        those(same, [&](const PortInfo &port) { return interfaceOf(port) == interfaceOf(wanted); });
    return matchOf(sameInterface.empty() ? same : sameInterface);
}

AdapterMatch byPlace(const PortInfo &wanted, const std::vector<PortInfo> &sameModel)
{
    auto nameless = those(sameModel, [](const PortInfo &port) { return port.serialNumber.isEmpty(); });
    auto here = those(nameless, [&](const PortInfo &port) { return port.usbPath == wanted.usbPath; });
    if (here.size() == 1 && !wanted.usbPath.isEmpty())
        return matchOf(std::move(here));
    return {nameless.empty() ? Kind::absent : Kind::ask, std::move(nameless)};
}

} // namespace

AdapterMatch sameAdapter(const PortInfo &wanted, const std::vector<PortInfo> &present)
{
    if (!wanted.isUsb())
        return matchOf(those(present, [&](const PortInfo &port) { return port.path == wanted.path; }));
    const auto sameModel = those(present, [&](const PortInfo &port) {
        return port.vendor == wanted.vendor && port.product == wanted.product;
    });
    return wanted.serialNumber.isEmpty() ? byPlace(wanted, sameModel) : bySerialNumber(wanted, sameModel);
}

} // namespace codewheel
