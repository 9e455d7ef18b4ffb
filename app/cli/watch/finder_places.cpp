// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watch/finder_places.h"

#include "cli/call/texts.h"
#include "links/port_access.h"
#include "links/serial_ports.h"

#include <QFileInfo>

#include <algorithm>

namespace codewheel {
namespace {

bool isPort(const QString &typed)
{
    return typed.contains(u'/') || typed.startsWith(QStringLiteral("tty")) ||
           QFileInfo::exists(portPath(typed));
}

const QStringList &linksWithoutPlace()
{
    static const QStringList links{QStringLiteral("training"), QStringLiteral("project")};
    return links;
}

// Whether there are any.
bool addListeners(FinderPlaces &places, const QString &typed)
{
    const std::size_t before = places.listeners.size();
    for (const LinkKind *kind : linkKinds())
        std::ranges::move(kind->listenersAt(typed), std::back_inserter(places.listeners));
    return places.listeners.size() != before;
}

tl::unexpected<Complaint> isLinkWithoutPlace(const QString &typed)
{
    return badInput(QStringLiteral("findTakesNoLink"),
                    CommandLine::tr("\"%1\" is a link. The search takes serial ports and hosts, such as "
                                    "ttyUSB0 or 192.168.0.5, and says which links lead there."),
                    {typed});
}

Checked<void> checkIsNoLink(const QString &typed)
{
    if (linksWithoutPlace().contains(typed))
        return isLinkWithoutPlace(typed);
    const auto link = LinkText::parse(typed);
    const auto has = [&](const LinkKind *kind) { return kind->schemes().contains(link->scheme); };
    if (!link || std::ranges::none_of(linkKinds(), has))
        return {};
    if (link->where.isEmpty() || linksWithoutPlace().contains(link->where))
        return isLinkWithoutPlace(typed);
    return badInput(
        QStringLiteral("findTakesNoLink"),
        CommandLine::tr("\"%1\" is a link. The search says which links lead to a place: type only %2."),
        {typed, link->where});
}

} // namespace

Checked<FinderPlaces> finderPlaces(const QStringList &typed)
{
    FinderPlaces places;
    if (typed.isEmpty()) {
        for (const PortInfo &port : serialPorts())
            places.ports << port.path;
        addListeners(places, {});
    }
    for (const QString &one : typed) {
        if (const auto checked = checkIsNoLink(one); !checked)
            return tl::unexpected(checked.error());
        if (addListeners(places, one))
            continue;
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
