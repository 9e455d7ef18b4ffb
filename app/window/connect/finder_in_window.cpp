// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/connect/finder_in_window.h"

#include "app/window/connect/port_rows.h"
#include "app/window/connect/trouble_of.h"
#include "app/window/kinds/window_kinds.h"
#include "links/port_search.h"
#include "widgets/find/find_page.h"

#include <utility>

namespace codewheel {
namespace {

using Take = std::function<void(const FinderNews &)>;

// One place after the other.
class SearchWork final : public BackgroundSteps::Work
{
public:
    SearchWork(std::vector<std::unique_ptr<PlaceFinder>> finders, Take take)
        : m_finders(std::move(finders))
        , m_take(std::move(take))
    {}

    BackgroundSteps::Taken step() override
    {
        while (m_at < m_finders.size() && m_finders[m_at]->isDone())
            ++m_at;
        if (m_at == m_finders.size())
            return {};
        return [take = m_take, news = m_finders[m_at]->next()] { take(news); };
    }
    void interrupt() override
    {
        for (const auto &finder : m_finders)
            finder->interrupt();
    }

private:
    const std::vector<std::unique_ptr<PlaceFinder>> m_finders;
    std::size_t m_at = 0;
    const Take m_take;
};

std::vector<HostSearch> searchesAt(const QString &host, int port)
{
    std::vector<HostSearch> searches;
    for (const WindowKind *kind : windowKinds())
        if (!host.isEmpty() && kind->hostSearch != nullptr)
            searches.push_back(kind->hostSearch(host, port));
    return searches;
}

// Serial ports, and what kinds of buses can listen to besides. That there are no ports is said only where
// there is nothing else, either.
PortRows placesToHear()
{
    PortRows listed = portRows(serialPorts());
    for (const WindowKind *kind : windowKinds()) {
        if (kind->interfaces == nullptr)
            continue;
        const PortRows its = kind->interfaces();
        const bool isOnlyOfPorts = listed.trouble.sentence == noSerialPortsText();
        if (!its.rows.empty() && (listed.trouble.sentence.isEmpty() || isOnlyOfPorts))
            listed.trouble = its.trouble;
        listed.rows.insert(listed.rows.end(), its.rows.begin(), its.rows.end());
    }
    return listed;
}

std::unique_ptr<PlaceFinder> listenerAt(const QString &place)
{
    for (const WindowKind *kind : windowKinds())
        if (kind->listenAt != nullptr)
            if (auto listener = kind->listenAt(place))
                return listener;
    return std::make_unique<PortSearch>(place, false);
}

} // namespace

FinderInWindow::FinderInWindow(FindPage &page)
    : QObject(&page)
    , m_page(page)
{
    connect(&page, &FindPage::portsWanted, this, &FinderInWindow::listPorts);
    connect(&page, &FindPage::searchWanted, this, &FinderInWindow::listen);
    connect(&page, &FindPage::askAgreed, this, &FinderInWindow::askSilent);
    connect(&page, &FindPage::cancelled, this, [this] {
        m_isCancelled = true;
        m_search.cancel();
    });
    connect(&m_search, &BackgroundSteps::ended, this, &FinderInWindow::endPhase);
}

void FinderInWindow::listPorts()
{
    const PortRows listed = placesToHear();
    m_page.setPorts(listed.rows, listed.trouble);
}

void FinderInWindow::listen(const FindWish &wish)
{
    m_host = wish.host;
    m_tcpPort = wish.tcpPort;
    m_silent.clear();
    m_isListening = true;
    std::vector<std::unique_ptr<PlaceFinder>> finders;
    for (const QString &port : wish.ports)
        finders.push_back(listenerAt(port));
    search(std::move(finders));
}

void FinderInWindow::search(std::vector<std::unique_ptr<PlaceFinder>> finders)
{
    m_isCancelled = false;
    m_page.begin();
    m_search.start(
        std::make_unique<SearchWork>(std::move(finders), [this](const FinderNews &news) { take(news); }));
}

void FinderInWindow::take(const FinderNews &news)
{
    if (m_isListening && news.kind == FinderNews::Kind::nobody && news.isSilent)
        m_silent << news.place;
    if (!news.why) {
        m_page.add(news);
        return;
    }
    const Trouble trouble = troubleOf(*news.why);
    FinderNews told = news;
    told.sentence = trouble.sentence;
    m_page.add(told);
    m_page.tell(trouble);
}

void FinderInWindow::endPhase()
{
    m_page.end();
    if (!std::exchange(m_isListening, false) || m_isCancelled)
        return;
    QStringList announced = askingAnnouncements(m_silent);
    QStringList places = m_silent;
    for (const HostSearch &host : searchesAt(m_host, m_tcpPort)) {
        places << host.place;
        announced << host.announcement;
    }
    if (!places.isEmpty())
        m_page.ask(places, announced);
}

void FinderInWindow::askSilent()
{
    std::vector<std::unique_ptr<PlaceFinder>> finders;
    for (const QString &port : m_silent)
        finders.push_back(std::make_unique<PortSearch>(port, true));
    for (HostSearch &host : searchesAt(m_host, m_tcpPort))
        finders.push_back(std::move(host.finder));
    search(std::move(finders));
}

} // namespace codewheel
