// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/paint_sheet.h"

#include "pdf/sheet_format.h"

#include <QPainter>

namespace codewheel {

void paintSheet(QPainter &painter, const Sheet &sheet)
{
    for (const Sheet::Line &line : sheet.lines) {
        painter.setPen(QPen(line.faint ? Qt::gray : Qt::black, line.width));
        painter.drawLine(line.line);
    }
    painter.setPen(QPen(Qt::black, sheet::thinLine));
    for (const Sheet::Bar &bar : sheet.bars) {
        painter.setBrush(bar.filled ? Qt::black : Qt::white);
        painter.drawRect(bar.box);
    }
    for (const Sheet::Text &text : sheet.texts) {
        painter.setFont(text.font);
        painter.drawText(QPointF(text.box.left(), text.baseLine), text.text);
    }
}

} // namespace codewheel
