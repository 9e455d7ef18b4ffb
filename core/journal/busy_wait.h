// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>
#include <ctime>

namespace codewheel {

// How long to wait for a database that another program has locked: as long as that one makes progress, seen
// by the file changing, since then it is merely a long queue; but not for one that holds the lock and does
// nothing.
class BusyWait
{
public:
    static constexpr std::chrono::seconds longestStandstill{5};
    static constexpr std::chrono::seconds longest{60};

    // `file`: empty for a database in memory.
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
