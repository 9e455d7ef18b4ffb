// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/value_change_table.h"

#include "widgets/look/fonts.h"

namespace codewheel {
namespace {

int alignmentOf(int column)
{
    const bool isValue = column == ValueChangeTable::before || column == ValueChangeTable::wanted;
    return int((isValue ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

} // namespace

QVariant ValueChangeTable::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(column);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case name:
        return tr("Parameter");
    case before:
        return tr("Old");
    case wanted:
        return tr("New");
    default:
        return tr("What happens");
    }
}

QVariant ValueChangeTable::cell(const ValueChangeRow &row, int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return alignmentOf(column);
    if (role == Qt::FontRole && (column == before || column == wanted))
        return numberFont();
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (column) {
    case name:
        return parameterName(row.parameter);
    case before:
        return row.before;
    case wanted:
        return row.wanted;
    default:
        return row.action;
    }
}

} // namespace codewheel
