// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/consent.h"
#include "cli/watch/finder_places.h"
#include "cli/watch/finder_search.h"
#include "finder/port_finder.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

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
