// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_item.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/roles.h"
#include "widgets/trend/curve_painter.h"
#include "widgets/trend/lane_layout.h"
#include "widgets/trend/track_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace codewheel {
namespace {

constexpr double flagSize = 5; // of a mark
constexpr double tagSize = 14; // of a cursor's letter
constexpr int mostColumns = 4'000;

// One for each pixel of the device.
int columnsOf(const QPainter &painter, double width)
{
    const double ratio = painter.device() == nullptr ? 1 : painter.device()->devicePixelRatioF();
    return std::clamp(static_cast<int>(std::lround(width * ratio)), 1, mostColumns);
}

} // namespace

void TrendItem::show(const TrendScene &scene, const QRectF &plot, const QPalette &palette)
{
    if (m_plot != plot)
        prepareGeometryChange();
    m_scene = scene;
    m_plot = plot;
    m_palette = palette;
    m_areas = layOutLanes(scene.lanes, plot);
    update();
}

QRectF TrendItem::boundingRect() const
{
    return m_plot.adjusted(-tagSize, -tagSize, tagSize, 0);
}

double TrendItem::x(Instant at) const
{
    return m_plot.left() + m_plot.width() * static_cast<double>((at - m_scene.span.from).count()) /
                               static_cast<double>((m_scene.span.to - m_scene.span.from).count());
}

Instant TrendItem::timeAt(double x) const
{
    const double part = (x - m_plot.left()) / std::max(m_plot.width(), 1.0);
    return m_scene.span.from +
           Instant(std::llround(part * static_cast<double>((m_scene.span.to - m_scene.span.from).count())));
}

void TrendItem::paint(QPainter *painter, const QStyleOptionGraphicsItem *, QWidget *)
{
    for (std::size_t lane = 0; lane < m_scene.lanes.size(); ++lane)
        paintLane(*painter, lane);
    painter->setRenderHint(QPainter::Antialiasing, false);
    paintMarks(*painter);
    paintPlayed(*painter);
    paintCursors(*painter);
}

void TrendItem::paintLane(QPainter &painter, std::size_t index) const
{
    const TrendLane &lane = m_scene.lanes[index];
    const QRectF &area = m_areas[index];
    if (index > 0) {
        const double y = std::round(m_areas[index - 1].bottom() + 3);
        painter.setPen(QPen(m_palette.color(QPalette::Dark), 1));
        painter.drawLine(QPointF(m_plot.left(), y), QPointF(m_plot.right(), y));
    }
    painter.save();
    painter.setClipRect(area.adjusted(0, -1, 0, 1), Qt::IntersectClip);
    CurvePainter curves(painter, area, m_scene.span, columnsOf(painter, area.width()));
    for (const TrendCurve &curve : lane.curves) {
        if (lane.isLogic())
            curves.drawBit(curve);
        else
            curves.draw(curve, lane.low, lane.high);
    }
    painter.restore();
    paintTitle(painter, lane, area);
}

// Each name in the colour of its curve, after a piece of it.
void TrendItem::paintTitle(QPainter &painter, const TrendLane &lane, const QRectF &area) const
{
    painter.setFont(textFont(TextSize::small));
    const QFontMetricsF metrics(painter.font());
    double left = area.left() + grid::unit;
    for (const TrendCurve &curve : lane.curves) {
        const double width = metrics.horizontalAdvance(curve.name);
        const QRectF line(left, area.top() - metrics.height(), width + 5 * grid::unit, metrics.height());
        if (line.right() > area.right())
            return;
        painter.setPen(QPen(curve.color, 2));
        painter.drawLine(QPointF(left, line.center().y()), QPointF(left + 3 * grid::unit, line.center().y()));
        painter.setPen(m_palette.color(QPalette::Text));
        painter.drawText(line.adjusted(4 * grid::unit, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         curve.name);
        left = line.right() + grid::unit;
    }
}

// Where several are closer than a pixel, one line is enough.
void TrendItem::paintMarks(QPainter &painter) const
{
    double last = -1;
    for (const Mark &mark : m_scene.marks) {
        const double at = std::round(x(mark.at));
        if (at < m_plot.left() || at > m_plot.right() || at == last)
            continue;
        last = at;
        const QColor color = markColor(mark, m_palette);
        painter.setPen(QPen(color, 1, Qt::DotLine));
        painter.drawLine(QPointF(at, m_plot.top()), QPointF(at, m_plot.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawPolygon(QPolygonF({QPointF(at - flagSize, m_plot.top() - flagSize),
                                       QPointF(at + flagSize, m_plot.top() - flagSize),
                                       QPointF(at, m_plot.top() + flagSize)}));
    }
}

void TrendItem::paintPlayed(QPainter &painter) const
{
    if (!m_scene.played || x(*m_scene.played) < m_plot.left() || x(*m_scene.played) > m_plot.right())
        return;
    const double at = std::round(x(*m_scene.played));
    const QColor color = roleColor(Role::attention, m_palette);
    painter.setPen(QPen(color, 2));
    painter.drawLine(QPointF(at, m_plot.top()), QPointF(at, m_plot.bottom()));
}

void TrendItem::paintCursors(QPainter &painter) const
{
    static constexpr std::array letters{'A', 'B'};
    painter.setFont(textFont(TextSize::small));
    for (std::size_t index = 0; index < m_scene.cursors.size(); ++index) {
        const auto cursor = m_scene.cursors[index];
        if (!cursor || x(*cursor) < m_plot.left() || x(*cursor) > m_plot.right())
            continue;
        const double at = std::round(x(*cursor));
        const bool isChosen = index == m_scene.chosenCursor;
        const QColor color = m_palette.color(isChosen ? QPalette::Highlight : QPalette::Text);
        painter.setPen(QPen(color, 1));
        painter.drawLine(QPointF(at, m_plot.top()), QPointF(at, m_plot.bottom()));
        const QRectF tag(at - tagSize / 2, m_plot.top() - tagSize, tagSize, tagSize);
        painter.fillRect(tag, color);
        painter.setPen(m_palette.color(isChosen ? QPalette::HighlightedText : QPalette::Base));
        painter.drawText(tag, Qt::AlignCenter, QString(QLatin1Char(letters[index])));
    }
}

} // namespace codewheel
