// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/heading_width.h"

#include <QHeaderView>

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

} // namespace codewheel
