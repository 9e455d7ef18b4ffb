// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/then_mark.h"

#include "widgets/look/grid.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QPainter>

#include <array>

namespace codewheel::then_mark {
namespace {

constexpr double half = 6; // of the diamond, and of the triangle beside it

struct ThenText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ThenMark)
};

QColor color(const QPalette &palette)
{
    return palette.color(QPalette::Highlight);
}

} // namespace

QPen pen(const QPalette &palette)
{
    return QPen(color(palette), 2, Qt::DotLine);
}

void paint(QPainter &painter, const QPalette &palette, QPointF at)
{
    const std::array corners{at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half),
                             at + QPointF(-half, 0)};
    painter.setPen(QPen(color(palette), 2));
    painter.setBrush(palette.color(QPalette::Window));
    painter.drawPolygon(corners.data(), static_cast<int>(corners.size()));
}

void paintLegend(QPainter &painter, const QPalette &palette, const QFont &font, const LegendRow &row)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    constexpr int indent = static_cast<int>(2 * half) + grid::unit;
    const int width = indent + painter.fontMetrics().horizontalAdvance(row.text);
    const int left = row.space.left() + std::max(0, (row.space.width() - width) / 2);
    const QPointF at(left + half, QRectF(row.space).center().y());
    if (row.now.isValid()) {
        const std::array corners{at + QPointF(0, -half), at + QPointF(half, half), at + QPointF(-half, half)};
        painter.setPen(Qt::NoPen);
        painter.setBrush(row.now);
        painter.drawPolygon(corners.data(), static_cast<int>(corners.size()));
    } else {
        paint(painter, palette, at);
    }
    painter.setPen(palette.color(QPalette::WindowText));
    painter.drawText(row.space.adjusted(left + indent - row.space.left(), 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, row.text);
    painter.restore();
}

QString nowText(const QString &position, const QString &age)
{
    const QString text =
        ThenText::tr("now %1", "position").arg(position.isEmpty() ? QString(QChar(0x2013)) : position);
    return age.isEmpty() ? text : QStringLiteral("%1, %2").arg(text, age);
}

QString thenText(const QString &position)
{
    return position.isEmpty() ? ThenText::tr("then: not known", "position")
                              : ThenText::tr("then %1", "position").arg(position);
}

} // namespace codewheel::then_mark
