// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <cstddef>
#include <deque>
#include <vector>

namespace codewheel {

// Which ids are in which row: rising ids, kept as runs without gaps, so that a million of them need no memory
// if none is left out. Grows at both ends.
class IdRuns
{
public:
    qint64 size() const { return m_runs.empty() ? 0 : m_runs.back().end() - m_runs.front().row; }
    bool isEmpty() const { return m_runs.empty(); }
    qint64 front() const { return m_runs.front().first; }
    qint64 back() const { return m_runs.back().first + m_runs.back().count - 1; }
    qint64 at(qint64 row) const;

    // Rising, all of them above back(), or all below front().
    void append(const std::vector<qint64> &ids);
    void append(qint64 first, qint64 last);
    void prepend(const std::vector<qint64> &ids);
    // Forgets those below `first`, and returns how many they were.
    qint64 dropBelow(qint64 first);
    void clear() { m_runs.clear(); }

private:
    struct Run
    {
        qint64 row = 0; // counted from where the first run began when it was made; may be negative
        qint64 first = 0;
        qint64 count = 0;
        qint64 end() const { return row + count; }
    };

    std::deque<Run> m_runs;
};

} // namespace codewheel
