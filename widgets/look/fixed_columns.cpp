// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/fixed_columns.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/heading_width.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QTableView>

#include <algorithm>

namespace codewheel {

void fixColumns(QTableView &table, const QStringList &widest)
{
    QHeaderView &header = *table.horizontalHeader();
    const QFontMetrics letters(numberFont());
    for (int column = 0; column < widest.size(); ++column) {
        header.setSectionResizeMode(column, QHeaderView::Interactive);
        header.resizeSection(column, std::max(headingWidth(header, column),
                                              letters.horizontalAdvance(widest[column]) + 4 * grid::unit));
    }
    header.setStretchLastSection(true);
}

} // namespace codewheel
