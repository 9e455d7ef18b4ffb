// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/id_runs.h"

#include <algorithm>

namespace codewheel {

qint64 IdRuns::at(qint64 row) const
{
    const qint64 wanted = row + m_runs.front().row;
    const auto after = std::ranges::upper_bound(m_runs, wanted, {}, &Run::row);
    const Run &run = *std::prev(after);
    return run.first + (wanted - run.row);
}

void IdRuns::append(const std::vector<qint64> &ids)
{
    for (const qint64 id : ids)
        append(id, id);
}

void IdRuns::append(qint64 first, qint64 last)
{
    const qint64 count = last - first + 1;
    if (!m_runs.empty() && first == back() + 1)
        m_runs.back().count += count;
    else
        m_runs.push_back({m_runs.empty() ? 0 : m_runs.back().end(), first, count});
}

void IdRuns::prepend(const std::vector<qint64> &ids)
{
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
        if (m_runs.empty()) {
            append(*id, *id);
        } else if (*id == front() - 1) {
            Run &run = m_runs.front();
            run = {run.row - 1, run.first - 1, run.count + 1};
        } else {
            m_runs.push_front({m_runs.front().row - 1, *id, 1});
        }
    }
}

qint64 IdRuns::dropBelow(qint64 first)
{
    const qint64 before = size();
    while (!m_runs.empty() && m_runs.front().first < first) {
        Run &run = m_runs.front();
        const qint64 gone = std::min(first - run.first, run.count);
        run = {run.row + gone, run.first + gone, run.count - gone};
        if (run.count == 0)
            m_runs.pop_front();
    }
    return before - size();
}

} // namespace codewheel
