// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/kinds/link_kind.h"
#include "cli/watch/finder_search.h"
#include "finder/port_finder.h"
#include "links/port_access.h"
#include "links/serial_ports.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"

#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// Where to look for encoders.
struct FinderPlaces
{
    QStringList ports{}; // paths
    std::vector<HostSearch> hosts{};
    std::vector<std::unique_ptr<PlaceFinder>> listeners{}; // they only listen
};

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
    return badInput("findTakesNoLink",
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
        "findTakesNoLink",
        CommandLine::tr("\"%1\" is a link. The search says which links lead to a place: type only %2."),
        {typed, link->where});
}

// As typed: a port is a path, or a name below /dev; everything else is a host, for every kind of bus that may
// be at one. Nothing typed: every serial port there is. A link is refused: its kind is what is looked for.
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

constexpr const char *findExamples[] = {"find", "find --listen", "find ttyUSB0 192.168.0.5 --yes"};

constexpr std::array findOptions{
    Option{"--listen", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "only listen: send nothing, connect nowhere")},
    Option{"--yes", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "ask silent lines and hosts without a question")},
};

// Silent lines and hosts are asked only if that is agreed to, after what would be sent was shown.
Checked<void> mayAsk(const Call &call, const QStringList &silent, const FinderPlaces &places)
{
    QStringList announced = askingAnnouncements(silent);
    QStringList where = silent;
    for (const HostSearch &host : places.hosts) {
        announced << host.announcement;
        where << host.place;
    }
    announced.removeDuplicates();
    std::ranges::transform(where, where.begin(), shownInLine);
    if (!call.arguments.has("--json"))
        call.terminal.print(
            u'\n' +
            sentence(CommandLine::tr("To find out more, %1 would be asked. Only reads are sent:"),
                     {where.join(QStringLiteral(", "))}) +
            u'\n' + announced.join(u'\n') + u'\n');
    return consent(call, CommandLine::tr("Ask?"),
                   CommandLine::tr("Nothing was sent. Add --yes to ask, or --listen to only listen."));
}

Checked<Answer> runFind(const Call &call)
{
    const auto places = finderPlaces(call.arguments.rest);
    if (!places)
        return tl::unexpected(places.error());
    FinderSearch search(call);
    for (const auto &listener : places->listeners)
        if (!search.isStopped())
            search.run(*listener);
    const QStringList silent = search.runAt(places->ports, false);
    const bool hasMore = !silent.isEmpty() || !places->hosts.empty();
    if (search.isStopped() || call.arguments.has("--listen") || !hasMore)
        return search.answer();
    search.pause();
    if (const auto agreed = mayAsk(call, silent, *places); !agreed) {
        Answer answer = search.answer();
        answer.complaint = agreed.error();
        return answer;
    }
    search.goOn();
    search.runAt(silent, true);
    for (const HostSearch &host : places->hosts)
        if (!search.isStopped())
            search.run(*host.finder);
    return search.answer();
}

} // namespace

const Subcommand findCommand{
    .name = "find",
    .usage = "[PORT|HOST]... [--listen] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "find encoders and gateways at ports and hosts"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Looks for whoever is at these serial ports, CAN interfaces and hosts, or at every port and "
        "interface of "
        "this\ncomputer. First it listens: where somebody talks, a master is at work, and nothing is sent. "
        "Then it says what it "
        "would\n"
        "send to lines that are silent, and to hosts, and asks whether it may. Only reads are sent. Each "
        "find is\n"
        "told with how sure it is and the link that leads there. Ends with 1 if nobody was found."),
    .examples = findExamples,
    .options = findOptions,
    .arguments = {0, 64},
    .run = runFind,
};

} // namespace codewheel
