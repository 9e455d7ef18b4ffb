// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/rod_picture.h"

#include "widgets/dial/then_mark.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace codewheel {

namespace {

// The context of these texts.
struct RodPictureText
{
    Q_DECLARE_TR_FUNCTIONS(RodPicture)
};

constexpr int headWidth = 22;
constexpr int headHeight = 34;
constexpr int rodHeight = 8;
constexpr int magnetWidth = 14;
constexpr int magnetHeight = 26;
constexpr int rodTick = 5;
constexpr int arrowHead = 4;
constexpr int ticks = 10; // over the measuring length

int smallLine()
{
    return QFontMetrics(textFont(TextSize::small)).height();
}

QString scaleNumber(const RodState &state, double share)
{
    const auto steps = qRound64(share * static_cast<double>(*state.length));
    return state.scale ? QLocale().toString(state.scale->millimetres(steps), 'f', 0)
                       : QLocale().toString(steps);
}

} // namespace

namespace {

// On the rod of now, or on that of then.
std::optional<double> placeOn(const auto &rod)
{
    if (!rod.position || !rod.length || *rod.length < 1 || !rod.countsUpToTheEnd)
        return {};
    const double share = static_cast<double>(*rod.position) / static_cast<double>(*rod.length);
    if (share < 0 || share > 1)
        return {};
    return *rod.countsUpToTheEnd ? share : 1 - share;
}

} // namespace

std::optional<double> magnetPlace(const RodState &state)
{
    return placeOn(state);
}

std::optional<double> magnetPlaceThen(const RodState &state)
{
    return state.then ? placeOn(*state.then) : std::nullopt;
}

int RodPicture::height()
{
    return smallLine() + grid::unit + headHeight + rodTick + smallLine() + grid::unit;
}

QPointF RodPicture::magnetAt(double place) const
{
    const double first = m_space.left() + headWidth + magnetWidth;
    const double last = m_space.right() - magnetWidth;
    const double middle = m_space.top() + smallLine() + grid::unit + headHeight / 2.0;
    return {first + place * (last - first), middle};
}

void RodPicture::paint(QPainter &painter, const QPalette &palette, const RodState &state) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawDirection(painter, palette, state);
    drawRod(painter, palette);
    drawScale(painter, palette, state);
    drawMagnet(painter, palette, state);
    drawThen(painter, palette, state);
    painter.restore();
}

void RodPicture::drawRod(QPainter &painter, const QPalette &palette) const
{
    const QPointF middle = magnetAt(0);
    const QRectF head(m_space.left() + 0.5, middle.y() - headHeight / 2.0 + 0.5, headWidth, headHeight - 1);
    const QRectF rod(head.right(), middle.y() - rodHeight / 2.0, m_space.right() - head.right() - 1,
                     rodHeight);
    painter.setPen(QPen(roleColor(Role::inactive, palette), 1));
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawRoundedRect(rod, rodHeight / 2.0, rodHeight / 2.0);
    painter.setBrush(palette.color(QPalette::Midlight));
    painter.drawRoundedRect(head, 3, 3);
}

// In mm, or in steps where the length of the rod is not known; without the measuring length, only ticks.
void RodPicture::drawScale(QPainter &painter, const QPalette &palette, const RodState &state) const
{
    const double top = magnetAt(0).y() + headHeight / 2.0;
    painter.setPen(QPen(roleColor(Role::inactive, palette), 1));
    for (int tick = 0; tick <= ticks; ++tick) {
        const double x = std::round(magnetAt(double(tick) / ticks).x()) + 0.5;
        const int longer = tick % (ticks / 2) == 0 ? rodTick : rodTick - 2;
        painter.drawLine(QPointF(x, top), QPointF(x, top + longer));
    }
    if (!state.length || !state.countsUpToTheEnd)
        return;
    painter.setFont(textFont(TextSize::small));
    painter.setPen(palette.color(QPalette::WindowText));
    const QString unit = state.scale ? RodPictureText::tr("mm") : RodPictureText::tr("steps", "unit");
    const double bottom = top + rodTick;
    for (const double share : {0.0, 0.5, 1.0}) {
        const double x = magnetAt(*state.countsUpToTheEnd ? share : 1 - share).x();
        const QString number = scaleNumber(state, share);
        const QString text = share == 0.5 ? number : number + QLatin1Char(' ') + unit;
        const double width = painter.fontMetrics().horizontalAdvance(text) + 2.0;
        const double left = std::clamp(x - width / 2, double(m_space.left()), m_space.right() - width);
        painter.drawText(QRectF(left, bottom, width, smallLine()), Qt::AlignCenter, text);
    }
}

void RodPicture::drawDirection(QPainter &painter, const QPalette &palette, const RodState &state) const
{
    const QString text =
        state.countsUpToTheEnd ? RodPictureText::tr("counts up") : RodPictureText::tr("direction not known");
    painter.setFont(textFont(TextSize::small));
    const double width = painter.fontMetrics().horizontalAdvance(text);
    const QRectF label(magnetAt(0.5).x() - width / 2, m_space.top(), width, smallLine());
    painter.setPen(palette.color(state.countsUpToTheEnd ? QPalette::WindowText : QPalette::PlaceholderText));
    painter.drawText(label, Qt::AlignCenter, text);
    if (!state.countsUpToTheEnd)
        return;
    const double y = label.center().y();
    const double tail = *state.countsUpToTheEnd ? label.right() + grid::unit : label.left() - grid::unit;
    const double sense = *state.countsUpToTheEnd ? 1 : -1;
    const double tip = magnetAt(*state.countsUpToTheEnd ? 1 : 0).x();
    painter.setPen(QPen(palette.color(QPalette::WindowText), 1.5));
    painter.drawLine(QPointF(tail, y), QPointF(tip - sense * arrowHead, y));
    painter.setBrush(palette.color(QPalette::WindowText));
    painter.setPen(Qt::NoPen);
    const std::array head{QPointF(tip, y), QPointF(tip - sense * 2 * arrowHead, y - arrowHead),
                          QPointF(tip - sense * 2 * arrowHead, y + arrowHead)};
    painter.drawPolygon(head.data(), static_cast<int>(head.size()));
}

// Only its outline where the position is an old one.
void RodPicture::drawMagnet(QPainter &painter, const QPalette &palette, const RodState &state) const
{
    const auto place = magnetPlace(state);
    if (!place)
        return;
    const QPointF at = magnetAt(*place);
    const QRectF magnet(at.x() - magnetWidth / 2.0, at.y() - magnetHeight / 2.0, magnetWidth, magnetHeight);
    const bool isPlain = state.role == Role::inactive || state.isLastKnown;
    const QColor color = state.isLastKnown ? roleColor(Role::inactive, palette)
                         : isPlain         ? palette.color(QPalette::WindowText)
                                           : roleColor(state.role, palette);
    painter.setPen(QPen(color, 1.5, state.isLastKnown ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(state.isLastKnown ? QBrush(palette.color(QPalette::Window)) : QBrush(color));
    painter.drawRoundedRect(magnet, 2, 2);
    const double tip = magnetAt(0).y() + headHeight / 2.0;
    painter.drawLine(QPointF(at.x(), magnet.bottom()), QPointF(at.x(), tip));
}

// A frame with a mark of its own, so that both can be told apart in one place.
void RodPicture::drawThen(QPainter &painter, const QPalette &palette, const RodState &state) const
{
    const auto place = magnetPlaceThen(state);
    if (!place)
        return;
    const QPointF at = magnetAt(*place);
    const QRectF frame(at.x() - magnetWidth / 2.0 - 2, at.y() - magnetHeight / 2.0 - 2, magnetWidth + 4,
                       magnetHeight + 4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(then_mark::pen(palette));
    painter.drawRoundedRect(frame, 2, 2);
    then_mark::paint(painter, palette, at);
}

} // namespace codewheel
