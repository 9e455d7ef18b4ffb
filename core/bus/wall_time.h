// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QDateTime>

#include <algorithm>
#include <vector>

namespace codewheel {

// From the thread of a bus: the computer slept for this long, just before.
struct Slept
{
    std::chrono::milliseconds duration;
};

// The date and time of the instants of a bus. Its clock stands still while the computer sleeps.
class WallTime
{
public:
    explicit WallTime(const QDateTime &begin) { setBegin(begin); } // of Instant 0

    // The computer slept for this long, just before `at`.
    void slept(std::chrono::milliseconds duration, Instant at) { m_sleeps.push_back({at, duration}); }
    // Its clock stood still while it was closed: at `at` it is `now`. The times of a bus never go back.
    void goOn(const QDateTime &now, Instant at)
    {
        if (const std::chrono::milliseconds missed(dateTime(at).msecsTo(now)); missed.count() > 0)
            slept(missed, at);
    }

    // Another clock from now on, on which it is `now` at `at`.
    void beginAnew(const QDateTime &now, Instant at)
    {
        setBegin(now.addMSecs(-std::chrono::floor<std::chrono::milliseconds>(at).count()));
        m_sleeps.clear();
    }

    QDateTime dateTime(Instant at) const
    {
        using std::chrono::milliseconds;
        return m_begin.addMSecs(std::chrono::duration_cast<milliseconds>(awakeOrNot(at)).count());
    }
    // When that was; within a sleep, its end. Before Instant 0 it is negative.
    Instant instantOf(const QDateTime &time) const
    {
        Instant at = std::chrono::milliseconds(m_begin.msecsTo(time));
        for (const Sleep &sleep : m_sleeps) {
            if (at < sleep.until)
                break;
            at = std::max(sleep.until, at - sleep.duration);
        }
        return at;
    }
    // Since 1970, UTC.
    Instant sinceEpoch(Instant at) const { return m_beginSinceEpoch + awakeOrNot(at); }

private:
    struct Sleep
    {
        Instant until;
        std::chrono::milliseconds duration;
    };

    // Asked for each value of each encoder: Qt would ask the system for the time zone each time.
    void setBegin(const QDateTime &begin)
    {
        m_begin = begin;
        m_beginSinceEpoch = std::chrono::milliseconds(begin.toMSecsSinceEpoch());
    }

    // Since Instant 0.
    Instant awakeOrNot(Instant at) const
    {
        Instant since = at;
        for (const Sleep &sleep : m_sleeps)
            if (at >= sleep.until)
                since += sleep.duration;
        return since;
    }

    QDateTime m_begin;
    Instant m_beginSinceEpoch{};
    std::vector<Sleep> m_sleeps;
};

} // namespace codewheel
