// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/comparison/comparison_model.h"

#include "catalog/hex_code.h"
#include "project/ring_plan_rules.h"
#include "widgets/look/roles.h"

#include <algorithm>

namespace codewheel {
namespace {

QString placeText(const RingStructure &ring, std::optional<std::size_t> place, const Catalog &catalog)
{
    if (!place)
        return {};
    const Participant &device = ring.at(*place);
    return QStringLiteral("%1  %2  %3")
        .arg(device.number.toString(), RingPlanRules().nameOf(device, catalog), hexCode(device.idCode, 2));
}

Role roleOf(ComparisonKind kind)
{
    switch (kind) {
    case ComparisonKind::same:
        return Role::running;
    case ComparisonKind::differs:
    case ComparisonKind::missing:
        return Role::fault;
    case ComparisonKind::additional:
    case ComparisonKind::moved:
        break;
    }
    return Role::attention;
}

} // namespace

int differences(const Comparison &comparison)
{
    return static_cast<int>(std::ranges::count_if(
        comparison, [](const ComparisonLine &line) { return line.kind != ComparisonKind::same; }));
}

int ComparisonModel::differences() const
{
    return codewheel::differences(m_comparison);
}

void ComparisonModel::compare(const RingStructure &configured, const RingStructure &connected,
                              const Catalog &catalog, bool onlyDifferences)
{
    m_comparison = compareRings(configured, connected);
    std::vector<ComparisonRow> rows;
    for (std::size_t i = 0; i < m_comparison.size(); ++i) {
        const ComparisonLine &line = m_comparison[i];
        const bool isSame = line.kind == ComparisonKind::same;
        if (!isSame || !onlyDifferences)
            rows.push_back(
                {.line = i,
                 .kind = line.kind,
                 .configured = placeText(configured, line.configured, catalog),
                 .connected = placeText(connected, line.connected, catalog),
                 .text = isSame ? QString() : comparisonText(line, configured, connected, catalog)});
    }
    setRows(std::move(rows));
}

QVariant ComparisonModel::headerCell(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case configuredColumn:
        return tr("Configured (project)");
    case connectedColumn:
        return tr("Connected (ring)");
    default:
        return tr("Difference");
    }
}

QVariant ComparisonModel::cell(const ComparisonRow &row, int column, int role) const
{
    const bool isDifference = column == differenceColumn;
    if (role == Qt::DecorationRole && isDifference)
        return lineIcon(roleIcon(roleOf(row.kind)), roleOf(row.kind));
    if (role == Qt::ToolTipRole)
        return row.text.isEmpty() ? comparisonKindName(row.kind) : row.text;
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case configuredColumn:
        return row.configured.isEmpty() ? QStringLiteral("-") : row.configured;
    case connectedColumn:
        return row.connected.isEmpty() ? QStringLiteral("-") : row.connected;
    default:
        return row.text.isEmpty() ? comparisonKindName(row.kind) : row.text;
    }
}

} // namespace codewheel
