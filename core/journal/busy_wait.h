// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <ctime>

namespace codewheel {

// How long to wait for a database that another program has locked: as long as that one gets on, which is seen
// by the file changing, since then it is but a long queue; and not for one that holds it and does nothing.
class BusyWait
{
public:
    static constexpr std::chrono::seconds longestStandstill{5};
    static constexpr std::chrono::seconds longest{60};

    // `file`: empty for one in memory.
    explicit BusyWait(QString file);
    // It is still locked: whether to try again.
    bool goesOn();

private:
    using Clock = std::chrono::steady_clock;

    bool hasChanged();

    QString m_file;
    Clock::time_point m_begun = Clock::now();
    Clock::time_point m_lastChange = m_begun;
    timespec m_changed{};
};

} // namespace codewheel
