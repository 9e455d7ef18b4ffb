// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/dial/rod_state.h"

#include <QPalette>
#include <QRect>

class QPainter;

namespace codewheel {

// The picture of a rod with its head at the left: the magnet on it, a scale below that counts the way the
// encoder does, and an arrow above in the direction it counts up.
class RodPicture
{
public:
    static constexpr int usualWidth = 232;

    // Metrics: those of the small text and of the numbers on the scale.
    static int height();

    void setSpace(const QRect &space) { m_space = space; }
    QRect space() const { return m_space; }
    // Where a magnet at `place` (magnetPlace()) is drawn, in logical pixels.
    QPointF magnetAt(double place) const;
    void paint(QPainter &painter, const QPalette &palette, const RodState &state) const;

private:
    void drawRod(QPainter &painter, const QPalette &palette) const;
    void drawScale(QPainter &painter, const QPalette &palette, const RodState &state) const;
    void drawDirection(QPainter &painter, const QPalette &palette, const RodState &state) const;
    void drawMagnet(QPainter &painter, const QPalette &palette, const RodState &state) const;
    void drawThen(QPainter &painter, const QPalette &palette, const RodState &state) const;

    QRect m_space;
};

} // namespace codewheel
