// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/port_rows.h"

#include "encoder/refusal_text.h"
#include "links/port_access.h"

#include <QStringList>

namespace codewheel {
namespace {

// Why the first port that cannot be opened cannot.
QString troubleOf(const std::vector<PortInfo> &ports)
{
    if (ports.empty())
        return noSerialPortsText();
    for (const PortInfo &port : ports)
        if (const auto hindrance = portHindrance(port.path))
            return refusalText(*hindrance);
    return {};
}

} // namespace

PortRows portRows(const std::vector<PortInfo> &ports)
{
    PortRows listed{.rows = {}, .trouble = troubleOf(ports)};
    for (const PortInfo &port : ports)
        listed.rows.push_back({port.path, port.description, port.serialNumber});
    return listed;
}

QStringList adapterRows()
{
    QStringList rows;
    for (const PortInfo &port : serialPorts())
        rows << QStringLiteral("%1: %2; USB %3:%4, at %5")
                    .arg(port.path, port.label())
                    .arg(port.vendor, 4, 16, QChar(u'0'))
                    .arg(port.product, 4, 16, QChar(u'0'))
                    .arg(port.usbPath);
    return rows;
}

} // namespace codewheel
