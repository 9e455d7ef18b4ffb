// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/stop_signals.h"
#include "cli/call/subcommand.h"
#include "finder/place_finder.h"

#include <QJsonArray>

#include <optional>
#include <vector>

namespace codewheel {

// The search of a call: one place after the other, told as it goes on. What asks the program to end ends the
// present step at once, and all others are left out.
class FinderSearch
{
public:
    explicit FinderSearch(const Call &call)
        : m_call(call)
    {
        goOn();
    }

    void run(PlaceFinder &finder); // to its end
    // Those of the ports that are silent.
    QStringList runAt(const QStringList &ports, bool mayAsk);
    bool isStopped();
    // Around a question: at one, the program ends as at any other.
    void pause();
    void goOn() { m_stop.emplace(); }
    Answer answer(); // all that was found so far

private:
    void take(const FinderNews &news);

    const Call &m_call;
    std::optional<StopSignals> m_stop; // empty: it pauses
    bool m_isStopped = false;
    std::vector<Found> m_found;
    QJsonArray m_news;
};

} // namespace codewheel
