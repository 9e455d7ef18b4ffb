// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/why/data_check_model.h"

#include "widgets/look/roles.h"

#include <algorithm>

namespace codewheel {
namespace {

Role roleOf(DataCheck::Outcome outcome)
{
    switch (outcome) {
    case DataCheck::Outcome::asExpected:
        return Role::running;
    case DataCheck::Outcome::remark:
        return Role::attention;
    case DataCheck::Outcome::differs:
        return Role::fault;
    case DataCheck::Outcome::notKnown:
        break;
    }
    return Role::inactive;
}

QString outcomeText(DataCheck::Outcome outcome)
{
    switch (outcome) {
    case DataCheck::Outcome::asExpected:
        return DataCheckModel::tr("as expected");
    case DataCheck::Outcome::remark:
        return DataCheckModel::tr("worth knowing");
    case DataCheck::Outcome::differs:
        return DataCheckModel::tr("differs");
    case DataCheck::Outcome::notKnown:
        break;
    }
    return DataCheckModel::tr("not known");
}

QString shownText(const DataCheck &check, int column)
{
    if (column == DataCheckModel::whatColumn)
        return check.what;
    const QString &text = column == DataCheckModel::expectedColumn ? check.expected : check.came;
    return text.isEmpty() ? QString(QChar(0x2013)) : text;
}

} // namespace

bool DataCheckModel::hasSteps(const DataChecks &checks) const
{
    return std::ranges::equal(rows(), checks, {}, &DataCheck::id, &DataCheck::id);
}

void DataCheckModel::show(const DataChecks &checks)
{
    if (!hasSteps(checks)) {
        setRows(checks);
        return;
    }
    for (int row = 0; row < rowCount(); ++row)
        if (const DataCheck &check = checks[static_cast<std::size_t>(row)]; check != rowAt(row))
            replace(row, check);
}

int DataCheckModel::rowOf(DataCheck::Id id) const
{
    for (int row = 0; row < rowCount(); ++row)
        if (rowAt(row).id == id)
            return row;
    return -1;
}

std::span<const ColumnHead> DataCheckModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Step")}, {QT_TR_NOOP("Expected")}, {QT_TR_NOOP("Came")}};
    return all;
}

QVariant DataCheckModel::cell(const DataCheck &check, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return shownText(check, column);
    case Qt::DecorationRole:
        return column == whatColumn
                   ? QVariant(lineIcon(roleIcon(roleOf(check.outcome)), roleOf(check.outcome)))
                   : QVariant();
    case Qt::ToolTipRole:
        return check.remedy.isEmpty() ? outcomeText(check.outcome) : check.remedy;
    case Qt::AccessibleTextRole:
        return column == whatColumn ? QStringLiteral("%1: %2").arg(check.what, outcomeText(check.outcome))
                                    : shownText(check, column);
    default:
        return {};
    }
}

} // namespace codewheel
