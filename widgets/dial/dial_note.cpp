// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/dial_note.h"

#include "widgets/look/grid.h"

#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace codewheel::dial_note {

namespace {

constexpr int indent = grid::smallIcon + grid::unit;
constexpr int mostNoteLines = 10;

} // namespace

int lines(const QFontMetrics &metrics, int width, const QString &note)
{
    const int line = metrics.height();
    const QRect space(0, 0, width - indent, mostNoteLines * line);
    const int height = metrics.boundingRect(space, Qt::TextWordWrap, note).height();
    return std::max(2, (height + line - 1) / line);
}

void paint(QPainter &painter, const QWidget &dial, const QRect &space, Role role, const QString &note)
{
    if (note.isEmpty())
        return;
    const QRect room = space.adjusted(indent, grid::unit, 0, 0);
    const QRect text = dial.fontMetrics().boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, note);
    const int left = space.left() + (space.width() - text.width() - indent) / 2;
    lineIcon(roleIcon(role), role).paint(&painter, QRect(left, text.top(), grid::smallIcon, grid::smallIcon));
    painter.setFont(dial.font());
    painter.setPen(dial.palette().color(QPalette::WindowText));
    painter.drawText(QRect(QPoint(left + indent, text.top()), text.size()), Qt::TextWordWrap, note);
}

} // namespace codewheel::dial_note
