// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "finder/found.h"
#include "finder/place_finder.h"

#include <QStringList>

#include <memory>
#include <vector>

namespace codewheel {

class FindPage;
struct FindWish;

// Carries out the searches of the page "Who is there?": first every port is listened to, then, if that is
// agreed to, silent ones and the host are asked.
class FinderInWindow : public QObject
{
    Q_OBJECT

public:
    explicit FinderInWindow(FindPage &page); // is its parent

    void listPorts();

private:
    void listen(const FindWish &wish);
    void askSilent();
    void search(std::vector<std::unique_ptr<PlaceFinder>> finders);
    void take(const FinderNews &news);
    void endPhase();

    FindPage &m_page;
    BackgroundSteps m_search;
    QString m_host;
    int m_tcpPort = 0;
    QStringList m_silent;       // ports, while listening
    bool m_isListening = false; // otherwise it asks
    bool m_isCancelled = false;
};

} // namespace codewheel
