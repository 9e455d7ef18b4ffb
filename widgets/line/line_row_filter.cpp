// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_row_filter.h"

#include "widgets/line/line_row_model.h"

namespace codewheel {

LineRowFilter::LineRowFilter(LineRowModel &rows, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_rows(rows)
{
    setSourceModel(&rows);
}

void LineRowFilter::hidePolls(bool hide)
{
    m_hidesPolls = hide;
    invalidateFilter();
}

bool LineRowFilter::filterAcceptsRow(int row, const QModelIndex &) const
{
    return !m_hidesPolls || !m_rows.rowAt(row).isPoll();
}

} // namespace codewheel
