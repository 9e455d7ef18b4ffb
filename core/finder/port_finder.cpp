// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/port_finder.h"

#include "encoder/refusal_text.h"
#include "encoder/sentence.h"
#include "finder/finder_texts.h"

#include <algorithm>

namespace codewheel {
namespace {

// Those of all protocols, in turns: the most usual ones of each come first.
std::deque<SerialSettings> listeningSettings()
{
    std::deque<SerialSettings> all;
    std::size_t longest = 0;
    for (const SpokenProtocol *protocol : spokenProtocols())
        longest = std::max(longest, protocol->usualSettings().size());
    for (std::size_t i = 0; i < longest; ++i)
        for (const SpokenProtocol *protocol : spokenProtocols()) {
            const auto its = protocol->usualSettings();
            if (i < its.size() && std::ranges::find(all, its[i]) == all.end())
                all.push_back(its[i]);
        }
    return all;
}

} // namespace

QStringList askingAnnouncements()
{
    QStringList all;
    for (const SpokenProtocol *protocol : spokenProtocols())
        all << protocol->announcement();
    return all;
}

PortFinder::PortFinder(ByteLink &link, bool mayAsk)
    : m_link(link)
    , m_mayAsk(mayAsk)
    , m_settings(listeningSettings())
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
    return {kind, m_link.name(), sentence, {}};
}

FinderNews PortFinder::end(FinderNews::Kind kind, const QString &sentence)
{
    m_isDone = true;
    m_link.close();
    return news(kind, sentence);
}

FinderNews PortFinder::refused(const Refusal &why)
{
    return end(FinderNews::Kind::refused, refusalText(why));
}

FinderNews PortFinder::foundBy(const Found &found)
{
    ++m_found;
    FinderNews its = news(FinderNews::Kind::found, found.sentence);
    its.found = found;
    return its;
}

FinderNews PortFinder::next()
{
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
    if (m_isStopped && !m_isDone)
        return end(FinderNews::Kind::nobody, FinderTexts::tr("The search was ended."));
    return its;
}

Result<void> PortFinder::open(const SerialSettings &settings)
{
    if (m_opened == settings)
        return {};
    if (m_opened)
        m_link.close();
    auto opened = m_link.open(settings);
    if (opened)
        m_opened = settings;
    return opened;
}

Result<QByteArray> PortFinder::hear(Instant duration)
{
    QByteArray heard;
    const Instant until = m_link.now() + duration;
    while (m_link.now() < until && !m_isStopped) {
        const auto bytes = m_link.read(until);
        if (!bytes)
            return tl::unexpected(bytes.error());
        heard += *bytes;
    }
    return heard;
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
    if (auto opened = open(m_settings.front()); !opened)
        return refused(opened.error());
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
        return news(
            FinderNews::Kind::heard,
            sentence(FinderTexts::tr("Bytes come, but none that make sense at %1. Nothing is sent; it is "
                                     "listened to with other settings."),
                     {here}));
    }
    m_isSilent = true;
    if (!m_mayAsk)
        return end(FinderNews::Kind::nobody,
                   FinderTexts::tr("The line is silent. Asking may find out more."));
    startAsking();
    return news(FinderNews::Kind::heard, FinderTexts::tr("The line is silent: it is asked."));
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
    for (const SpokenProtocol *protocol : spokenProtocols())
        m_askings.push_back(protocol->ask(m_link.name()));
}

// Where one protocol is spoken, no other is.
FinderNews PortFinder::ask()
{
    while (!m_askings.empty() && m_askings.front()->isDone()) {
        if (m_found > 0)
            m_askings.clear();
        else
            m_askings.pop_front();
    }
    if (m_askings.empty())
        return end(m_found > 0 ? FinderNews::Kind::looking : FinderNews::Kind::nobody,
                   m_found > 0
                       ? FinderTexts::tr("All were asked.")
                       : FinderTexts::tr("Nobody answers. Check wires (A and B may be swapped) and supply."));
    Asking &asking = *m_askings.front();
    const SerialSettings settings = asking.settings();
    const QString doing = asking.doing();
    if (auto opened = open(settings); !opened)
        return refused(opened.error());
    const auto found = asking.step(m_link, m_isStopped);
    if (!found)
        return refused(found.error());
    if (*found)
        return foundBy(**found);
    return news(FinderNews::Kind::looking, QStringLiteral("%1 (%2)").arg(doing, formatText(settings)));
}

} // namespace codewheel
