// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QPixmap>

class QPainter;

namespace codewheel {

// The turning part of the dial: a Gray-coded disc, most significant track inside, its zero at the top. Drawn
// once per size and palette.
class DiscFace
{
public:
    static constexpr int tracks = 7;

    // Of the disc's radius: where the tracks begin; inside is the hub.
    static constexpr double hubShare = 0.36;

    // Round the origin, with the lines of the painter: what is printed is sharp.
    static void paint(QPainter &painter, int diameter, const QPalette &palette);
    const QPixmap &picture(int diameter, qreal scale, const QPalette &palette);
    void clear() { m_picture = {}; }

private:
    QPixmap m_picture;
};

} // namespace codewheel
