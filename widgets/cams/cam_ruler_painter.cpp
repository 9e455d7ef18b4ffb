// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_ruler_painter.h"

#include "widgets/cams/cam_rows.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

namespace codewheel {
namespace {

constexpr double barRadius = 3;
constexpr int rulerTick = 5;
constexpr int smallTickHeight = 3;
constexpr double narrowestBar = 3;
constexpr int paleBar = 70;    // alpha of an active cam that is not on
constexpr int encoderLine = 3; // height

} // namespace

CamRulerPainter::CamRulerPainter(CamRuler &ruler, double tickDistance)
    : m_ruler(ruler)
    , m_sheet(ruler.sheet())
    , m_scale(ruler.scale())
    , m_palette(ruler.palette())
    , m_tickDistance(tickDistance)
    , m_axis(camAxisHeight(ruler))
    , m_painter(&ruler)
{
    m_painter.fillRect(ruler.rect(), m_palette.color(QPalette::Base));
}

void CamRulerPainter::drawAxis()
{
    m_painter.fillRect(QRect(0, 0, m_ruler.width(), m_axis), m_palette.color(QPalette::Window));
    m_painter.setPen(roleColor(Role::inactive, m_palette));
    m_painter.drawLine(0, m_axis - 1, m_ruler.width(), m_axis - 1);
    const std::int64_t step = m_scale.tickStep(m_tickDistance);
    const std::int64_t small = m_scale.tickStep(m_tickDistance / 5);
    for (const std::int64_t tick : m_scale.ticks(small))
        m_painter.drawLine(QPointF(x(tick), m_axis - 1 - smallTickHeight), QPointF(x(tick), m_axis - 1));
    m_painter.setFont(textFont(TextSize::small));
    for (const std::int64_t tick : m_scale.ticks(step))
        drawTick(tick);
}

void CamRulerPainter::drawTick(std::int64_t tick)
{
    const QString text = cam_texts::position(tick);
    const int width = m_painter.fontMetrics().horizontalAdvance(text);
    // A number at an end of the ruler stays inside it.
    const double left = std::clamp(x(tick) - width / 2.0, 1.0, std::max(1.0, m_ruler.width() - width - 1.0));
    m_painter.setPen(roleColor(Role::inactive, m_palette));
    m_painter.drawLine(QPointF(x(tick), m_axis - 1 - rulerTick), QPointF(x(tick), m_axis - 1));
    m_painter.setPen(m_palette.color(QPalette::WindowText));
    m_painter.drawText(QRectF(left, 0, width + 1, m_axis - rulerTick - 1), Qt::AlignLeft | Qt::AlignVCenter,
                       text);
}

QRectF CamRulerPainter::barOf(const cam_circle::Stretch &stretch, const QRect &row) const
{
    const double left = x(stretch.first);
    const double right = std::max(x(stretch.last + 1), left + narrowestBar);
    const int above = row.height() / 6;
    return {QPointF(left, row.top() + above), QPointF(right, row.bottom() - above - 1)};
}

void CamRulerPainter::drawRow(std::size_t number, bool showsHint)
{
    const QRect row = m_ruler.rowRect(number);
    const bool isCurrent = number == m_sheet.current();
    if (isCurrent)
        m_painter.fillRect(row, m_palette.color(QPalette::AlternateBase));
    m_painter.setPen(m_palette.color(QPalette::Midlight));
    m_painter.drawLine(row.bottomLeft(), row.bottomRight());
    const Cam &cam = m_sheet.cam(number);
    if (!cam_circle::isEmpty(cam)) {
        for (const auto &stretch : cam_circle::stretches(cam, m_sheet.largest()))
            drawBar(number, stretch, row);
    } else if (showsHint) {
        m_painter.setFont(textFont(TextSize::small));
        m_painter.setPen(m_palette.color(QPalette::PlaceholderText));
        m_painter.drawText(row, Qt::AlignCenter, CamRuler::tr("Drag to draw cam %1").arg(number));
    }
    drawEncoders(number, row);
    if (isCurrent && m_ruler.hasFocus()) {
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(m_palette.color(QPalette::Text), 1, Qt::DotLine));
        m_painter.drawRect(row.adjusted(0, 0, -1, -2));
    }
}

// Filled: on. Pale: active, but off or not known. Dashed: inactive.
void CamRulerPainter::drawBar(std::size_t number, const cam_circle::Stretch &stretch, const QRect &row)
{
    const QRectF bar = barOf(stretch, row);
    if (bar.right() < 0 || bar.left() > m_ruler.width())
        return;
    const Cam &cam = m_sheet.cam(number);
    const bool isOn = cam.active && m_sheet.isOn(number).value_or(false);
    const QColor rim = roleColor(!m_sheet.check(number, cam) ? Role::fault
                                 : cam.active                ? Role::setBit
                                                             : Role::inactive,
                                 m_palette);
    QColor fill = rim;
    fill.setAlpha(isOn ? 255 : cam.active ? paleBar : 0);
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setBrush(fill);
    m_painter.setPen(QPen(rim, 1.5, cam.active ? Qt::SolidLine : Qt::DashLine));
    m_painter.drawRoundedRect(bar.adjusted(0.75, 0.75, -0.75, -0.75), barRadius, barRadius);
    if (number == m_sheet.current()) {
        if (stretch.hasStart)
            drawEdge(bar, CamGrip::start);
        if (stretch.hasStop)
            drawEdge(bar, CamGrip::stop);
    }
    m_painter.setRenderHint(QPainter::Antialiasing, false);

    const QRectF inner = bar.intersected(QRectF(row)).adjusted(10, 0, -10, 0);
    const QString text = cam_texts::range(cam);
    m_painter.setFont(textFont(TextSize::small));
    if (m_painter.fontMetrics().horizontalAdvance(text) <= inner.width()) {
        m_painter.setPen(isOn ? textOn(m_sheet.check(number, cam) ? Role::setBit : Role::fault, m_palette)
                              : m_palette.color(QPalette::Text));
        m_painter.drawText(inner, Qt::AlignCenter, text);
    }
}

void CamRulerPainter::drawEdge(const QRectF &bar, CamGrip edge)
{
    const bool isChosen = m_ruler.grip() == edge;
    const double width = isChosen ? 5 : 3;
    const double at = edge == CamGrip::start ? bar.left() : bar.right() - width;
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_palette.color(QPalette::Text));
    m_painter.drawRoundedRect(
        QRectF(at, bar.top() - (isChosen ? 2 : 0), width, bar.height() + (isChosen ? 4 : 0)), 1.5, 1.5);
}

// What the encoder has instead, as a line below the bar.
void CamRulerPainter::drawEncoders(std::size_t number, const QRect &row)
{
    const auto known = m_sheet.known(m_sheet.number());
    if (!known || known->cam.at(number) == m_sheet.cam(number) || cam_circle::isEmpty(known->cam.at(number)))
        return;
    for (const auto &stretch : cam_circle::stretches(known->cam.at(number), m_sheet.largest())) {
        const QRectF bar = barOf(stretch, row);
        m_painter.fillRect(QRectF(bar.left(), row.bottom() - encoderLine, bar.width(), encoderLine),
                           roleColor(m_sheet.isOld() ? Role::inactive : Role::attention, m_palette));
    }
}

void CamRulerPainter::drawPosition()
{
    const auto &position = m_sheet.live().position;
    if (!position)
        return;
    const double left = x(position->first);
    const double right = x(position->last + 1);
    const bool isOld = m_sheet.live().isOld;
    const QColor ink = isOld ? roleColor(Role::inactive, m_palette) : m_palette.color(QPalette::Text);
    const double middle = std::floor((left + right) / 2) + 0.5;
    const QRectF line(middle - 1, m_axis, 2, m_ruler.height() - m_axis);
    if (right - left > line.width()) {
        QColor band = ink;
        band.setAlpha(paleBar / 2);
        m_painter.fillRect(QRectF(left, m_axis, right - left, line.height()), band);
    }
    m_painter.setPen(QPen(ink, line.width(), isOld ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(QPointF(middle, line.top()), QPointF(middle, line.bottom()));
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setPen(isOld ? QPen(ink, 1.5) : QPen(Qt::NoPen));
    m_painter.setBrush(isOld ? m_palette.brush(QPalette::Base) : QBrush(ink));
    const std::array tip{QPointF(middle - 5, m_axis - 7), QPointF(middle + 5, m_axis - 7),
                         QPointF(middle, m_axis)};
    m_painter.drawPolygon(tip.data(), static_cast<int>(tip.size()));
    m_painter.setRenderHint(QPainter::Antialiasing, false);
}

void CamRulerPainter::drawValues(std::size_t number, CamGrip grip)
{
    const Cam &cam = m_sheet.cam(number);
    if (grip != CamGrip::stop)
        drawFlag(cam.start);
    if (grip != CamGrip::start)
        drawFlag(cam.stop);
}

void CamRulerPainter::drawFlag(std::int64_t position)
{
    m_painter.setFont(numberFont(TextSize::small));
    const QString text = cam_texts::position(position);
    const int width = m_painter.fontMetrics().horizontalAdvance(text) + 2 * grid::unit;
    const double left =
        std::clamp(x(position) - width / 2.0, 0.0, std::max(0.0, 1.0 * m_ruler.width() - width));
    const QRectF flag(left, 1, width, m_axis - 2);
    m_painter.fillRect(flag, m_palette.color(QPalette::Highlight));
    m_painter.setPen(m_palette.color(QPalette::HighlightedText));
    m_painter.drawText(flag, Qt::AlignCenter, text);
}

} // namespace codewheel
