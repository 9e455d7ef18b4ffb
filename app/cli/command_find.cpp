// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/consent.h"
#include "cli/finder_places.h"
#include "cli/jobs.h"
#include "cli/json.h"
#include "cli/stop_signals.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/sentence.h"
#include "links/port_search.h"

#include <QJsonArray>

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

// One search.
class Search
{
public:
    explicit Search(const Call &call)
        : m_call(call)
    {}

    // To its end.
    void run(PlaceFinder &finder)
    {
        while (!finder.isDone()) {
            if (isStopped())
                finder.interrupt();
            take(finder.next());
        }
        m_call.terminal.showProgress({});
    }
    // One port after the other. Those that are silent.
    QStringList runAt(const QStringList &ports, bool mayAsk)
    {
        QStringList silent;
        for (const QString &port : ports) {
            if (isStopped())
                break;
            PortSearch finder(port, mayAsk);
            run(finder);
            if (finder.isSilent())
                silent << port;
        }
        return silent;
    }
    bool isStopped() { return m_isStopped = m_isStopped || m_stop.came(); }
    Answer answer() const;
    const std::vector<Found> &found() const { return m_found; }

private:
    void take(const FinderNews &news);

    const Call &m_call;
    StopSignals m_stop;
    bool m_isStopped = false;
    std::vector<Found> m_found;
    QJsonArray m_news;
};

void Search::take(const FinderNews &news)
{
    const QString line = news.place + QStringLiteral(": ") + news.sentence;
    if (news.found)
        m_found.push_back(*news.found);
    const bool isShown = !m_call.arguments.has("--json");
    if (news.kind == FinderNews::Kind::looking) {
        if (isShown)
            m_call.terminal.showProgress(line);
        return;
    }
    m_call.terminal.showProgress({});
    if (isShown)
        m_call.terminal.print(line + u'\n');
    m_news.append(
        QJsonObject{{QStringLiteral("place"), news.place}, {QStringLiteral("text"), news.sentence}});
}

QJsonObject foundJson(const Found &one)
{
    return {{QStringLiteral("place"), one.place},
            {QStringLiteral("kind"), one.kind},
            {QStringLiteral("settings"), textJson(one.settings)},
            {QStringLiteral("text"), one.sentence},
            {QStringLiteral("certainty"), certaintyKey(one.certainty)},
            {QStringLiteral("masterAtWork"), one.isMasterAtWork},
            {QStringLiteral("link"), one.link}};
}

QString tableOf(const std::vector<Found> &found)
{
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("settings"), CommandLine::tr("sure"),
               QStringLiteral("--link"), CommandLine::tr("who")});
    for (const Found &one : found)
        table.add({one.place, one.settings.isEmpty() ? QStringLiteral("-") : one.settings,
                   certaintyText(one.certainty), one.link, one.sentence});
    return table.toString();
}

Answer Search::answer() const
{
    QJsonArray found;
    for (const Found &one : m_found)
        found.append(foundJson(one));
    Answer answer{.json = {{QStringLiteral("found"), found}, {QStringLiteral("news"), m_news}}};
    if (!m_found.empty())
        answer.text = u'\n' + tableOf(m_found);
    if (m_isStopped)
        answer.complaint = aboutCancelling();
    else if (m_found.empty())
        answer.complaint =
            Complaint{ExitCode::refused, QStringLiteral("nobodyFound"), CommandLine::tr("Nobody was found.")};
    return answer;
}

// Silent lines and hosts are asked only if that is agreed to, after what would be sent was shown.
Checked<void> mayAsk(const Call &call, const QStringList &silent, const FinderPlaces &places)
{
    QStringList announced = silent.isEmpty() ? QStringList() : askingAnnouncements();
    QStringList where = silent;
    for (const HostSearch &host : places.hosts) {
        announced << host.announcement;
        where << host.place;
    }
    announced.removeDuplicates();
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
    Search search(call);
    const QStringList silent = search.runAt(places->ports, false);
    const bool hasMore = !silent.isEmpty() || !places->hosts.empty();
    if (search.isStopped() || call.arguments.has("--listen") || !hasMore)
        return search.answer();
    if (const auto agreed = mayAsk(call, silent, *places); !agreed) {
        Answer answer = search.answer();
        answer.complaint = agreed.error();
        return answer;
    }
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
        "Looks for whoever is at these serial ports and hosts, or at every serial port of this computer. "
        "First\n"
        "it listens: where somebody talks, a master is at work, and nothing is sent. Then it says what it "
        "would\n"
        "send to lines that are silent, and to hosts, and asks whether it may. Only reads are sent. Each "
        "find is\n"
        "told with how sure it is and the link that leads there. Ends with 1 if nobody was found."),
    .examples = findExamples,
    .options = findOptions,
    .minimumArguments = 0,
    .maximumArguments = 64,
    .needsBus = false,
    .run = runFind,
};

} // namespace codewheel
