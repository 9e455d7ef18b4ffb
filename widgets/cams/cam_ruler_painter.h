// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_circle.h"
#include "widgets/cams/cam_ruler.h"

#include <QPainter>

namespace codewheel {

// Draws a cam ruler, part by part. Made by CamRuler for a single frame.
class CamRulerPainter
{
public:
    // tickDistance: the fewest columns between numbered ticks
    CamRulerPainter(CamRuler &ruler, double tickDistance);

    void drawAxis();
    void drawRow(std::size_t cam, bool showsHint);
    void drawPosition();
    // The positions changed by a drag, above the row.
    void drawValues(std::size_t cam, CamGrip grip);

private:
    double x(std::int64_t position) const { return m_scale.x(static_cast<double>(position)); }
    QRectF barOf(const cam_circle::Stretch &stretch, const QRect &row) const;
    void drawTick(std::int64_t tick);
    void drawEdge(const QRectF &bar, CamGrip edge);
    void drawBar(std::size_t cam, const cam_circle::Stretch &stretch, const QRect &row);
    void drawEncoders(std::size_t cam, const QRect &row);
    void drawFlag(std::int64_t position);

    const CamRuler &m_ruler;
    const CamSheet &m_sheet;
    const RulerScale &m_scale;
    const QPalette m_palette;
    double m_tickDistance;
    int m_axis; // height
    QPainter m_painter;
};

} // namespace codewheel
