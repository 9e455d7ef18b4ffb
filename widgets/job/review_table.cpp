// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/review_table.h"

namespace codewheel {
namespace {

QVariant alignmentOf(const ReviewColumn &column)
{
    return QVariant((column.kind == ReviewColumn::Kind::value ? Qt::AlignRight : Qt::AlignLeft) |
                    Qt::AlignVCenter);
}

} // namespace

void ReviewTable::setColumns(std::vector<ReviewColumn> columns, TextSize size)
{
    beginResetModel();
    m_columns = std::move(columns);
    m_size = size;
    endResetModel();
}

void ReviewTable::show(std::vector<ReviewRow> rows)
{
    if (rows != this->rows())
        setRows(std::move(rows));
}

QVariant ReviewTable::headerCell(int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return at(column).title;
    case Qt::TextAlignmentRole:
        return alignmentOf(at(column));
    case Qt::FontRole:
        return textFont(m_size);
    default:
        return {};
    }
}

QVariant ReviewTable::cell(const ReviewRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return row.cells.value(column);
    case Qt::ToolTipRole:
        return row.tips.value(column).isEmpty() ? row.cells.value(column) : row.tips.value(column);
    case Qt::TextAlignmentRole:
        return alignmentOf(at(column));
    case Qt::FontRole:
        return at(column).kind == ReviewColumn::Kind::code ? numberFont(m_size) : textFont(m_size);
    default:
        return {};
    }
}

} // namespace codewheel
