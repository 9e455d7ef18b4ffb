// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/port_finder.h"

#include "finder/finder_texts.h"
#include "finder/listening.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr int silentCharacters = 4; // before each request: more than the 3.5 between frames of Modbus RTU

// Those of all protocols, in turns: the most usual ones of each come first.
std::deque<SerialSettings> listeningSettings(const QString &port)
{
    const auto protocols = spokenProtocolsAt(port);
    std::deque<SerialSettings> all;
    std::size_t longest = 0;
    for (const SpokenProtocol *protocol : protocols)
        longest = std::max(longest, protocol->usualSettings().size());
    for (std::size_t i = 0; i < longest; ++i)
        for (const SpokenProtocol *protocol : protocols) {
            const auto its = protocol->usualSettings();
            if (i < its.size() && std::ranges::find(all, its[i]) == all.end())
                all.push_back(its[i]);
        }
    return all;
}

} // namespace

QStringList askingAnnouncements(const QStringList &ports)
{
    QStringList all;
    for (const SpokenProtocol *protocol : spokenProtocols())
        if (std::ranges::any_of(ports, [&](const QString &port) {
                return protocol->fitsAt(port) != SpokenProtocol::Fit::none;
            }))
            all << protocol->announcement();
    return all;
}

PortFinder::PortFinder(ByteLink &link, bool mayAsk)
    : m_link(link)
    , m_mayAsk(mayAsk)
    , m_settings(listeningSettings(m_link.name()))
{}

PortFinder::~PortFinder()
{
    m_link.close();
}

void PortFinder::interrupt()
{
    m_isStopped = true;
    m_link.interrupt();
}

FinderNews PortFinder::news(FinderNews::Kind kind, const QString &sentence) const
{
    return {kind, m_link.name(), sentence};
}

FinderNews PortFinder::end(FinderNews::Kind kind, const QString &sentence)
{
    m_isDone = true;
    m_link.close();
    return news(kind, sentence);
}

FinderNews PortFinder::refused(const Refusal &why)
{
    m_isDone = true;
    m_link.close();
    return refusedNews(m_link.name(), why);
}

FinderNews PortFinder::foundBy(const Found &found)
{
    ++m_found;
    FinderNews its = news(FinderNews::Kind::found, found.sentence);
    its.found = found;
    return its;
}

FinderNews PortFinder::cancelled()
{
    m_isSilent = false;
    return end(FinderNews::Kind::nobody, FinderTexts::tr("The search was cancelled."));
}

// A step that was cut short says nothing about the line, unless somebody was heard.
FinderNews PortFinder::next()
{
    if (m_isStopped)
        return cancelled();
    FinderNews its;
    switch (m_phase) {
    case Phase::listen:
        its = listen();
        break;
    case Phase::tune:
        its = tune();
        break;
    case Phase::ask:
        its = ask();
        break;
    }
    const bool isKnown =
        its.kind == FinderNews::Kind::found || (its.kind == FinderNews::Kind::heard && m_isDone);
    return m_isStopped && !isKnown ? cancelled() : its;
}

Result<void> PortFinder::open(const SerialSettings &settings)
{
    if (m_opened == settings)
        return {};
    auto opened = m_link.open(settings); // anew at once: a master may poll in between
    if (opened)
        m_opened = settings;
    return opened;
}

Result<QByteArray> PortFinder::hear(Instant duration)
{
    return hearUntil(m_link, m_link.now() + duration, m_isStopped);
}

// Empty: nobody sends, as far as some bytes more or less tell.
Result<QByteArray> PortFinder::hearStrangers(Instant duration)
{
    auto heard = hear(duration);
    if (!heard || heard->isEmpty())
        return heard;
    auto more = hear(listeningAgain);
    if (!more)
        return more;
    *heard += *more;
    if (heard->size() > glitches)
        return heard;
    noteSenseless(*heard);
    return QByteArray();
}

// What is still unread belongs to the settings of the request before.
Result<QByteArray> PortFinder::hearBefore(const SerialSettings &settings)
{
    const bool isOther = m_opened != settings;
    const bool listensAgain = std::exchange(m_listensAgain, false) && !isOther;
    auto heard = hearStrangers(listensAgain ? listeningAgain : m_opened->timeOf(silentCharacters));
    if (!isOther || !heard || !heard->isEmpty())
        return heard;
    if (auto opened = open(settings); !opened)
        return tl::unexpected(opened.error());
    return hearStrangers(listeningAgain);
}

std::optional<Found> PortFinder::sense(const QByteArray &bytes) const
{
    for (const SpokenProtocol *protocol : spokenProtocols())
        if (auto found = protocol->heard(m_link.name(), *m_opened, bytes))
            return found;
    return std::nullopt;
}

// Whatever is spoken, at any rate, some bytes come: a silent line need not be listened to at others.
FinderNews PortFinder::listen()
{
    if (!m_opened) {
        if (auto opened = open(m_settings.front()); !opened)
            return refused(opened.error());
        return news(FinderNews::Kind::looking, sentence(FinderTexts::tr("Listening at %1. Nothing is sent."),
                                                        {formatText(m_settings.front())}));
    }
    const auto heard = hear(firstListening);
    if (!heard)
        return refused(heard.error());
    if (!heard->isEmpty()) {
        m_phase = Phase::tune;
        if (const auto found = sense(*heard)) {
            m_isDone = true;
            return foundBy(*found);
        }
        const QString here = formatText(m_settings.front());
        m_settings.pop_front();
        return news(FinderNews::Kind::heard,
                    sentence(FinderTexts::tr("Bytes come, but none that make sense at %1. Nothing is sent; "
                                             "other settings are tried by listening."),
                             {here}));
    }
    m_isSilent = true;
    if (!m_mayAsk) {
        FinderNews its =
            end(FinderNews::Kind::nobody, FinderTexts::tr("The line is silent. Asking may find out more."));
        its.isSilent = true;
        return its;
    }
    startAsking();
    return news(FinderNews::Kind::heard, FinderTexts::tr("Nobody sends on this line by itself."));
}

FinderNews PortFinder::tune()
{
    if (m_settings.empty())
        return end(
            FinderNews::Kind::nobody,
            FinderTexts::tr("Somebody talks on this line, but it makes sense with no usual setting. Nothing "
                            "was sent."));
    const SerialSettings settings = m_settings.front();
    m_settings.pop_front();
    if (auto opened = open(settings); !opened)
        return refused(opened.error());
    const auto heard = hear(nextListening);
    if (!heard)
        return refused(heard.error());
    if (const auto found = sense(*heard)) {
        m_isDone = true;
        return foundBy(*found);
    }
    const QString next = m_settings.empty() ? QString() : formatText(m_settings.front());
    return news(
        FinderNews::Kind::looking,
        next.isEmpty()
            ? sentence(FinderTexts::tr("Bytes come, but none that make sense at %1."), {formatText(settings)})
            : sentence(FinderTexts::tr("Bytes come, but none that make sense at %1: next %2."),
                       {formatText(settings), next}));
}

void PortFinder::startAsking()
{
    m_phase = Phase::ask;
    for (const SpokenProtocol *protocol : spokenProtocolsAt(m_link.name()))
        m_turns.push_back({protocol, protocol->ask(m_link.name())});
}

// Where one protocol is spoken, no other is.
void PortFinder::dropAsked()
{
    while (!m_turns.empty() && m_turns.front().asking->isDone()) {
        if (m_found > 0)
            m_turns.clear();
        else
            m_turns.pop_front();
    }
}

FinderNews PortFinder::ask()
{
    dropAsked();
    if (m_turns.empty())
        return endOfAsking();
    Asking &asking = *m_turns.front().asking;
    const SerialSettings settings = asking.settings();
    const auto strangers = hearBefore(settings);
    if (!strangers)
        return refused(strangers.error());
    if (!strangers->isEmpty())
        return masterCame(*strangers);
    if (m_isStopped)
        return cancelled();
    const QString doing = asking.doing();
    const auto asked = asking.step(m_link, m_isStopped);
    if (!asked)
        return refused(asked.error());
    if (asked->others.areStrangers || isOfOther(asked->others.all))
        return masterCame(asked->others.all);
    noteSenseless(asked->others.all);
    return asked->found
               ? confirm(*asked->found)
               : news(FinderNews::Kind::looking, QStringLiteral("%1 (%2)").arg(doing, formatText(settings)));
}

// A find counts if the line is quiet after it.
FinderNews PortFinder::confirm(const Found &found)
{
    const auto strangers = hearStrangers(quietAfterFind);
    if (!strangers)
        return refused(strangers.error());
    return strangers->isEmpty() ? foundBy(found) : masterCame(*strangers);
}

FinderNews PortFinder::endOfAsking()
{
    if (m_found > 0)
        return end(FinderNews::Kind::looking, FinderTexts::tr("All were asked."));
    if (!m_senseless.isEmpty())
        return end(FinderNews::Kind::nobody,
                   sentence(FinderTexts::tr("Bytes came at %1, but none that make sense. Check format, wires "
                                            "(A and B may be swapped) and termination, and whether two "
                                            "encoders have the same address."),
                            {m_senseless.join(QStringLiteral("; "))}));
    return end(FinderNews::Kind::nobody,
               FinderTexts::tr("Nobody answers. Check wires (A and B may be swapped) and supply."));
}

// Who it is, its next bytes may tell.
FinderNews PortFinder::masterCame(const QByteArray &bytes)
{
    const auto more = hear(nextListening);
    const auto found = sense(bytes + more.value_or(QByteArray()));
    FinderNews its = end(found ? FinderNews::Kind::found : FinderNews::Kind::heard,
                         FinderTexts::tr("A master began to send while we asked: stopped. Nothing more is "
                                         "sent on this port."));
    its.found = found;
    return its;
}

// Another protocol than the one asked with.
bool PortFinder::isOfOther(const QByteArray &bytes) const
{
    return std::ranges::any_of(spokenProtocols(), [&](const SpokenProtocol *protocol) {
        return protocol != m_turns.front().protocol && protocol->heard(m_link.name(), *m_opened, bytes);
    });
}

void PortFinder::noteSenseless(const QByteArray &bytes)
{
    const QString here = formatText(*m_opened);
    if (bytes.isEmpty() || m_senseless.contains(here))
        return;
    m_listensAgain = m_senseless.isEmpty(); // once: it takes time
    m_senseless << here;
}

} // namespace codewheel
