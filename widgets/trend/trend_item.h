// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/trend_scene.h"

#include <QGraphicsItem>
#include <QPalette>

namespace codewheel {

// What stands in the plot of a chart: the curves in their lanes, marks and cursors. An item of our own, since
// series of Qt Charts cost too much with so many points.
class TrendItem : public QGraphicsItem
{
public:
    explicit TrendItem(QGraphicsItem *parent)
        : QGraphicsItem(parent)
    {}

    void show(const TrendScene &scene, const QRectF &plot, const QPalette &palette);
    const std::vector<QRectF> &lanes() const { return m_areas; }
    double x(Instant at) const;
    Instant timeAt(double x) const;

    QRectF boundingRect() const override;
    void paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *widget) override;

private:
    void paintLane(QPainter &painter, std::size_t index) const;
    void paintTitle(QPainter &painter, const TrendLane &lane, const QRectF &area) const;
    void paintMarks(QPainter &painter) const;
    void paintCursors(QPainter &painter) const;
    void paintPlayed(QPainter &painter) const;

    TrendScene m_scene;
    QRectF m_plot;
    std::vector<QRectF> m_areas;
    QPalette m_palette;
};

} // namespace codewheel
