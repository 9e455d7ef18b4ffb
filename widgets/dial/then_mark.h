// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QPen>
#include <QPointF>
#include <QRect>
#include <QString>

class QPainter;

// How dials show what will be behind a change of the position: a dotted line with a diamond, where the
// pointer of now has a full one with a triangle. Shared by disc and rod.
namespace codewheel::then_mark {

QPen pen(const QPalette &palette);
void paint(QPainter &painter, const QPalette &palette, QPointF at); // the diamond

// "now 12 345" behind the mark of its pointer.
struct LegendRow
{
    QRect space;
    QString text;
    QColor now; // colour of the pointer of now; not valid: the row of then
};
void paintLegend(QPainter &painter, const QPalette &palette, const QFont &font, const LegendRow &row);

QString nowText(const QString &position, const QString &age); // age: of an old one, otherwise empty
QString thenText(const QString &position);                    // empty: it is not known

} // namespace codewheel::then_mark
