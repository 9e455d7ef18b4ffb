// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/review_table.h"

namespace codewheel {
namespace {

using Kind = ReviewColumn::Kind;

QVariant alignmentOf(const ReviewColumn &column)
{
    const bool isRight = column.kind == Kind::value || column.kind == Kind::number;
    return QVariant((isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

QFont fontOf(const ReviewRow &row, const ReviewColumn &column, TextSize size)
{
    const bool isCode = column.kind == Kind::code && row.kind == ReviewRow::Kind::value && !row.isThere;
    if (isCode || column.kind == Kind::number)
        return numberFont(size);
    QFont font = textFont(size);
    font.setBold(row.kind == ReviewRow::Kind::head && column.kind == Kind::text);
    return font;
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
    const auto isSameLine = [](const ReviewRow &a, const ReviewRow &b) {
        return a.kind == b.kind && a.place == b.place;
    };
    if (!std::ranges::equal(rows, this->rows(), isSameLine)) {
        setRows(std::move(rows));
        return;
    }
    for (int row = 0; row < rowCount(); ++row)
        if (auto &now = rows[static_cast<std::size_t>(row)]; rowAt(row) != now)
            replace(row, std::move(now));
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
        return !row.tip.isEmpty()                 ? row.tip
               : row.tips.value(column).isEmpty() ? row.cells.value(column)
                                                  : row.tips.value(column);
    case Qt::TextAlignmentRole:
        return alignmentOf(at(column));
    case Qt::FontRole:
        return fontOf(row, at(column), m_size);
    default:
        return {};
    }
}

} // namespace codewheel
