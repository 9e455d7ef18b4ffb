// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/comparison/comparison_model.h"

#include "widgets/look/roles.h"
#include "widgets/models/age_text.h"
#include "widgets/structure_editor/plan_edits.h"

#include <QGuiApplication>
#include <QPalette>

namespace codewheel {
namespace {

QString placeText(const Participant &device, const PlanEdits &plan)
{
    QStringList parts{device.number.toString(), plan.nameOf(device)};
    if (const QString code = plan.codeOf(device); !code.isEmpty())
        parts << code;
    return parts.join(QStringLiteral("  "));
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

void ComparisonModel::compare(const PlanEdits &plan, const ConnectedBus &connected, bool onlyDifferences)
{
    const PlanRules &rules = plan.rules();
    m_comparison = rules.compare(plan.project(), plan.bus(), connected);
    std::vector<ComparisonRow> rows;
    for (std::size_t i = 0; i < m_comparison.size(); ++i) {
        const ComparisonLine &line = m_comparison[i];
        const bool isSame = line.kind == ComparisonKind::same;
        if (isSame && onlyDifferences)
            continue;
        ComparisonRow &row = rows.emplace_back(ComparisonRow{i, line.kind, {}, {}, {}});
        if (line.configured)
            row.configured =
                placeText(devicesOn(plan.project(), plan.bus())[*line.configured].participant, plan);
        if (line.connected) {
            const Participant &there = connected.devices[*line.connected];
            row.connected = placeText(there, plan);
            if (const auto old = connected.notLive.find(there.number); old != connected.notLive.end())
                row.old = old->second;
        }
        if (!isSame)
            row.text = rules.comparisonText(line, plan.project(), plan.bus(), connected, plan.catalog());
    }
    setRows(std::move(rows));
}

std::span<const ColumnHead> ComparisonModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Configured (project)")}, {QT_TR_NOOP("Connected")}, {QT_TR_NOOP("Difference")}};
    return all;
}

// Of before are the connected device and what follows from it.
QVariant ComparisonModel::cell(const ComparisonRow &row, int column, int role) const
{
    const bool isDifference = column == differenceColumn;
    const bool isOld = row.old && column != configuredColumn;
    switch (role) {
    case Qt::DecorationRole:
        return isDifference && !isOld ? lineIcon(roleIcon(roleOf(row.kind)), roleOf(row.kind)) : QVariant();
    case Qt::ForegroundRole:
        return isOld ? QVariant(QGuiApplication::palette().placeholderText()) : QVariant();
    case Qt::ToolTipRole: {
        const QString text = row.text.isEmpty() ? comparisonKindName(row.kind) : row.text;
        return row.old ? text + u'\n' + ageSentence(*row.old) : text;
    }
    case Qt::AccessibleTextRole:
        return isOld ? tr("%1, not up to date").arg(textOf(row, column)) : textOf(row, column);
    case Qt::DisplayRole:
        return textOf(row, column);
    default:
        return {};
    }
}

QString ComparisonModel::textOf(const ComparisonRow &row, int column)
{
    if (column == differenceColumn)
        return row.text.isEmpty() ? comparisonKindName(row.kind) : row.text;
    const QString &device = column == configuredColumn ? row.configured : row.connected;
    return device.isEmpty() ? QString(QChar(0x2013)) : device;
}

} // namespace codewheel
