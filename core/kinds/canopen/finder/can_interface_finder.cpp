// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/finder/can_interface_finder.h"

#include "finder/finder_texts.h"
#include "vocabulary/sentence.h"

namespace codewheel {

FinderNews CanInterfaceFinder::next()
{
    if (m_isStopped)
        return end({FinderNews::Kind::nobody, m_link->name(), FinderTexts::tr("The search was cancelled.")});
    return m_isOpen ? listen() : open();
}

FinderNews CanInterfaceFinder::end(FinderNews news)
{
    m_isDone = true;
    m_link->close();
    return news;
}

FinderNews CanInterfaceFinder::open()
{
    if (const auto opened = m_link->open(CanUse::watch); !opened)
        return end(refusedNews(m_link->name(), opened.error()));
    m_isOpen = true;
    return {FinderNews::Kind::looking, m_link->name(), FinderTexts::tr("Listening. Nothing is sent.")};
}

FinderNews CanInterfaceFinder::listen()
{
    for (const Instant until = m_link->now() + listening; m_link->now() < until && !m_isStopped;) {
        const auto news = m_link->receive(until);
        if (!news)
            return end(refusedNews(m_link->name(), news.error()));
        for (const CanFrame &frame : news->frames)
            m_heard.take(frame);
    }
    if (m_heard.isAnything()) {
        Found found = canBusAt(m_link->name(), QStringLiteral("can:") + m_link->name(), std::nullopt,
                               m_heard.sentence());
        found.isMasterAtWork = m_heard.isMasterAtWork();
        if (const auto rate = m_link->status().rate)
            found.settings = QStringLiteral("%1 Bd").arg(*rate);
        return end({FinderNews::Kind::found, m_link->name(), found.sentence, found});
    }
    if (m_heard.hasErrors())
        return end(
            {FinderNews::Kind::nobody, m_link->name(),
             FinderTexts::tr("Only errors are heard: the rate of the interface may be another one than "
                             "that of the bus.")});
    return end({FinderNews::Kind::nobody, m_link->name(),
                FinderTexts::tr("Nobody is heard. codewheel-cli scan --ask asks each node.")});
}

} // namespace codewheel
