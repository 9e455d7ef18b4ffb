// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/comparison.h"

#include "kinds/interbus/ring/numbering.h"

#include <algorithm>

namespace codewheel {

bool isSameKind(const RingDevice &a, const RingDevice &b)
{
    return a.deviceCode == b.deviceCode && a.inWords == b.inWords && a.outWords == b.outWords;
}

namespace {

bool stayed(const RingDevice &a, const RingDevice &b)
{
    return isSameKind(a, b) && a.level == b.level && isOnLocalBus(a) == isOnLocalBus(b);
}

// Finds which devices stayed, and walks both rings side by side.
class RingComparer
{
public:
    RingComparer(const RingStructure &configured, const RingStructure &connected)
        : m_configured(configured)
        , m_connected(connected)
        , m_partner(configured.size())
        , m_isTaken(connected.size())
    {}

    Comparison compare()
    {
        findStayed();
        findMoved();
        walk();
        return std::move(m_lines);
    }

private:
    using Index = std::size_t;

    void findStayed();
    void findMoved();
    void walk();
    void addGap(Index configuredEnd, Index connectedEnd);
    void skipTaken(Index &connected, Index end) const;

    const RingStructure &m_configured;
    const RingStructure &m_connected;
    // For each configured device its connected counterpart, and whether it stayed.
    struct Partner
    {
        std::optional<Index> connected;
        bool stayed = false;
    };
    std::vector<Partner> m_partner;
    std::vector<bool> m_isTaken; // connected devices that have a counterpart
    Comparison m_lines;
    Index m_nextConfigured = 0; // of the walk
    Index m_nextConnected = 0;
};

// The longest common subsequence. Among equal ones the earliest match is taken: in a row of equal devices,
// the last ones are missing.
void RingComparer::findStayed()
{
    const Index rows = m_configured.size();
    const Index columns = m_connected.size();
    std::vector<std::vector<std::uint32_t>> length(rows + 1, std::vector<std::uint32_t>(columns + 1));
    for (Index i = rows; i-- > 0;)
        for (Index j = columns; j-- > 0;)
            length[i][j] = stayed(m_configured[i], m_connected[j])
                               ? length[i + 1][j + 1] + 1
                               : std::max(length[i + 1][j], length[i][j + 1]);
    for (Index i = 0, j = 0; i < rows && j < columns;) {
        if (stayed(m_configured[i], m_connected[j])) {
            m_partner[i] = {j, true};
            m_isTaken[j] = true;
            ++i, ++j;
        } else if (length[i + 1][j] >= length[i][j + 1])
            ++i;
        else
            ++j;
    }
}

void RingComparer::findMoved()
{
    for (Index i = 0; i < m_configured.size(); ++i)
        for (Index j = 0; j < m_connected.size() && !m_partner[i].connected; ++j)
            if (!m_isTaken[j] && isSameKind(m_configured[i], m_connected[j])) {
                m_partner[i] = {j, false};
                m_isTaken[j] = true;
            }
}

void RingComparer::walk()
{
    for (Index i = 0; i < m_configured.size(); ++i)
        if (m_partner[i].stayed) {
            const Index j = *m_partner[i].connected;
            addGap(i, j);
            m_lines.push_back({ComparisonKind::same, i, j});
            m_nextConfigured = i + 1;
            m_nextConnected = j + 1;
        }
    addGap(m_configured.size(), m_connected.size());
}

void RingComparer::skipTaken(Index &connected, Index end) const
{
    while (connected < end && m_isTaken[connected])
        ++connected;
}

// What is between two devices that stayed: paired up as long as there are any on both sides.
void RingComparer::addGap(Index configuredEnd, Index connectedEnd)
{
    Index j = m_nextConnected;
    for (Index i = m_nextConfigured; i < configuredEnd; ++i) {
        skipTaken(j, connectedEnd);
        if (m_partner[i].connected)
            m_lines.push_back({ComparisonKind::moved, i, m_partner[i].connected});
        else if (j < connectedEnd)
            m_lines.push_back({ComparisonKind::differs, i, j++});
        else
            m_lines.push_back({ComparisonKind::missing, i, std::nullopt});
    }
    for (skipTaken(j, connectedEnd); j < connectedEnd; skipTaken(++j, connectedEnd))
        m_lines.push_back({ComparisonKind::additional, std::nullopt, j});
}

} // namespace

Comparison compareRings(const RingStructure &configured, const RingStructure &connected)
{
    return RingComparer(configured, connected).compare();
}

namespace {

bool hasCode(const ComparisonLine &line, unsigned code, const RingStructure &configured,
             const RingStructure &connected)
{
    return (line.configured && configured[*line.configured].deviceCode == code) ||
           (line.connected && connected[*line.connected].deviceCode == code);
}

} // namespace

Comparison certainLines(const Comparison &comparison, const RingStructure &configured,
                        const RingStructure &connected)
{
    const auto differsBeside = [&](std::ptrdiff_t line, std::ptrdiff_t step, unsigned code) {
        for (auto at = line + step; at >= 0 && at < std::ssize(comparison); at += step) {
            const ComparisonLine &beside = comparison[static_cast<std::size_t>(at)];
            if (!hasCode(beside, code, configured, connected))
                return false;
            if (beside.kind != ComparisonKind::same)
                return true;
        }
        return false;
    };
    Comparison certain;
    for (std::ptrdiff_t i = 0; i < std::ssize(comparison); ++i) {
        const ComparisonLine &line = comparison[static_cast<std::size_t>(i)];
        if (line.kind != ComparisonKind::same)
            continue;
        const unsigned code = connected[*line.connected].deviceCode;
        if (!differsBeside(i, -1, code) && !differsBeside(i, 1, code))
            certain.push_back(line);
    }
    return certain;
}

} // namespace codewheel
