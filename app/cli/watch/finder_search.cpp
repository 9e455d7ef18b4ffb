// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watch/finder_search.h"

#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "links/port_search.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"

#include <poll.h>
#include <thread>

namespace codewheel {
namespace {

// Interrupts a finder as soon as a signal has come, while it lives.
std::jthread interruptsOn(const StopSignals &stop, PlaceFinder &finder)
{
    return std::jthread(
        [waited = pollfd{stop.descriptor(), POLLIN, 0}, &finder](const std::stop_token &ended) mutable {
            constexpr int betweenPolls = 20; // ms
            while (!ended.stop_requested())
                if (::poll(&waited, 1, betweenPolls) > 0) {
                    finder.interrupt();
                    return;
                }
        });
}

// Empty: what is typed behind --link ends at a comma, and control characters cannot be typed.
QString linkToType(const Found &one)
{
    return one.place.contains(u',') || shownInLine(one.place) != one.place ? QString() : one.link;
}

QJsonObject foundJson(const Found &one)
{
    return {{QStringLiteral("place"), one.place},
            {QStringLiteral("kind"), one.kind},
            {QStringLiteral("settings"), textJson(one.settings)},
            {QStringLiteral("text"), one.sentence},
            {QStringLiteral("certainty"), certaintyKey(one.certainty)},
            {QStringLiteral("masterAtWork"), one.isMasterAtWork},
            {QStringLiteral("link"), textJson(linkToType(one))}};
}

QString tableOf(const std::vector<Found> &found)
{
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("settings"), CommandLine::tr("sure"),
               QStringLiteral("--link"), CommandLine::tr("who")});
    for (const Found &one : found)
        table.add({one.place, orDash(one.settings), certaintyText(one.certainty), orDash(linkToType(one)),
                   one.sentence});
    return table.toString();
}

// About the places to which no link leads.
QString remarks(const std::vector<Found> &found)
{
    QStringList places;
    for (const Found &one : found)
        if (linkToType(one).isEmpty())
            places << shownInLine(one.place);
    places.removeDuplicates();
    QString text;
    for (const QString &place : places)
        text +=
            u'\n' +
            sentence(CommandLine::tr("--link cannot name %1, since there is a comma or a control character "
                                     "in it. Make a symbolic link without them, and name that."),
                     {place}) +
            u'\n';
    return text;
}

} // namespace

bool FinderSearch::isStopped()
{
    m_isStopped = m_isStopped || (m_stop && m_stop->came());
    return m_isStopped;
}

void FinderSearch::pause()
{
    isStopped();
    m_stop.reset();
}

void FinderSearch::run(PlaceFinder &finder)
{
    const std::jthread watch = interruptsOn(*m_stop, finder);
    while (!finder.isDone()) {
        if (isStopped())
            finder.interrupt();
        take(finder.next());
    }
    m_call.terminal.showProgress({});
}

QStringList FinderSearch::runAt(const QStringList &ports, bool mayAsk)
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

void FinderSearch::take(const FinderNews &news)
{
    const Complaint told = news.why ? complaintAbout(*news.why) : Complaint{.key = {}, .text = news.sentence};
    const QString line = shownInLine(news.place + QStringLiteral(": ") + told.text);
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
        m_call.terminal.print(line + u'\n' + commandToCopy(told.command));
    m_news.append(QJsonObject{{QStringLiteral("place"), news.place},
                              {QStringLiteral("text"), told.text},
                              {QStringLiteral("command"), textJson(told.command)}});
}

Answer FinderSearch::answer()
{
    QJsonArray found;
    for (const Found &one : m_found)
        found.append(foundJson(one));
    Answer answer{.json = {{QStringLiteral("found"), found}, {QStringLiteral("news"), m_news}}};
    if (!m_found.empty())
        answer.text = u'\n' + tableOf(m_found) + remarks(m_found);
    if (isStopped())
        answer.complaint = aboutCancelling();
    else if (m_found.empty())
        answer.complaint = notDone("nobodyFound", CommandLine::tr("No encoder or gateway was found."));
    return answer;
}

} // namespace codewheel
