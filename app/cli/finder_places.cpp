// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/finder_places.h"

#include "cli/ring/gateway_link_text.h"
#include "links/port_access.h"
#include "links/serial_ports.h"

#include <QFileInfo>

namespace codewheel {
namespace {

bool isPort(const QString &typed)
{
    return typed.contains(u'/') || typed.startsWith(QStringLiteral("tty")) ||
           QFileInfo::exists(portPath(typed));
}

} // namespace

Checked<FinderPlaces> finderPlaces(const QStringList &typed)
{
    FinderPlaces places;
    if (typed.isEmpty())
        for (const PortInfo &port : serialPorts())
            places.ports << port.path;
    for (const QString &one : typed) {
        if (isPort(one)) {
            places.ports << portPath(one);
            continue;
        }
        const auto host = gatewayMeant({QString::fromLatin1(modbusTcpLink), one, {}});
        if (!host)
            return tl::unexpected(host.error());
        places.hosts.push_back(*host);
    }
    return places;
}

} // namespace codewheel
