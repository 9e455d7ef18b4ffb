// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/heading_width.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QTableView>

#include <algorithm>

namespace codewheel {

int headingWidth(const QHeaderView &header, int column)
{
    const QAbstractItemModel &model = *header.model();
    const QString text = model.headerData(column, Qt::Horizontal).toString();
    const QVariant own = model.headerData(column, Qt::Horizontal, Qt::FontRole);
    const QFont font = own.isValid() ? own.value<QFont>() : header.font();
    QFont bold = font;
    bold.setBold(true);
    return header.sectionSizeHint(column) - QFontMetrics(bold).horizontalAdvance(text) +
           QFontMetrics(font).horizontalAdvance(text);
}

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
