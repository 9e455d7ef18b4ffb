// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/finder_places.h"

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
        for (const LinkKind *kind : linkKinds()) {
            auto host = kind->hostSearch(one);
            if (!host)
                return tl::unexpected(host.error());
            if (*host)
                places.hosts.push_back(*std::move(*host));
        }
    }
    return places;
}

} // namespace codewheel
