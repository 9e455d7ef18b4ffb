// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/disc_face.h"

#include "widgets/look/roles.h"

#include <QPainter>
#include <QPainterPath>
#include <QtMath>

namespace codewheel {

namespace {

constexpr int codes = 1 << DiscFace::tracks;
constexpr double degreesPerCode = 360.0 / codes;
constexpr double trackGap = 0.8; // pixels

bool isDark(int code, int track)
{
    const int gray = code ^ (code >> 1);
    return ((gray >> (DiscFace::tracks - 1 - track)) & 1) != 0;
}

// Clockwise from the top, in codes.
QPainterPath sector(double inner, double outer, int from, int to)
{
    const auto square = [](double radius) { return QRectF(-radius, -radius, 2 * radius, 2 * radius); };
    const double start = 90.0 - from * degreesPerCode;
    const double sweep = -(to - from) * degreesPerCode;
    QPainterPath path;
    path.arcMoveTo(square(outer), start);
    path.arcTo(square(outer), start, sweep);
    path.arcTo(square(inner), start + sweep, -sweep);
    path.closeSubpath();
    return path;
}

void drawTrack(QPainter &painter, int track, double inner, double outer)
{
    for (int code = 0; code < codes; ++code) {
        if (!isDark(code, track))
            continue;
        const int from = code;
        while (code + 1 < codes && isDark(code + 1, track))
            ++code;
        painter.drawPath(sector(inner, outer, from, code + 1));
    }
}

QPixmap drawnDisc(int diameter, qreal scale, const QPalette &palette)
{
    const int side = qFloor(diameter * scale);
    QPixmap picture(side, side);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(diameter / 2.0, diameter / 2.0);
    DiscFace::paint(painter, diameter, palette);
    return picture;
}

} // namespace

void DiscFace::paint(QPainter &painter, int diameter, const QPalette &palette)
{
    const double radius = diameter / 2.0 - 1;
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawEllipse(QPointF(), radius, radius);

    const double innermost = radius * DiscFace::hubShare;
    const double step = (radius - 3 - innermost) / DiscFace::tracks;
    painter.setBrush(roleColor(Role::inactive, palette));
    for (int track = 0; track < DiscFace::tracks; ++track) {
        const double inner = innermost + track * step;
        drawTrack(painter, track, inner, inner + step - trackGap);
    }
    painter.setPen(QPen(roleColor(Role::inactive, palette), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(), diameter / 2.0 - 0.5, diameter / 2.0 - 0.5);
}

const QPixmap &DiscFace::picture(int diameter, qreal scale, const QPalette &palette)
{
    if (m_picture.isNull() || m_picture.width() != qFloor(diameter * scale) ||
        !qFuzzyCompare(m_picture.devicePixelRatio(), scale))
        m_picture = drawnDisc(diameter, scale, palette);
    return m_picture;
}

} // namespace codewheel
