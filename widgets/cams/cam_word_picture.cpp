// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_word_picture.h"

#include "vocabulary/cam_program.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"
#include "widgets/look/roles.h"

#include <QPainter>

#include <bit>

namespace codewheel {
namespace {

constexpr int bits = 32;
constexpr int firstPartBit = 8; // D8..D24: a part of the position
constexpr int lastPartBit = 24;
constexpr int widestCell = 22;
constexpr int narrowestCell = 12;

} // namespace

CamWordPicture::CamWordPicture(QWidget *parent)
    : ValueWidget(parent)
{
    setAccessibleName(tr("What IN will hold"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { updateGeometry(); });
}

void CamWordPicture::setShift(unsigned shift, std::int64_t largest)
{
    m_shift = shift;
    m_positionBits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(largest)));
    setToolTip(valueText());
    update();
}

std::optional<int> CamWordPicture::positionBit(int bit) const
{
    const int of = bit - firstPartBit + static_cast<int>(m_shift);
    return bit >= firstPartBit && bit <= lastPartBit && of < m_positionBits ? std::optional(of)
                                                                            : std::nullopt;
}

QString CamWordPicture::valueText() const
{
    const auto lowest = positionBit(firstPartBit);
    if (!lowest || m_shift == CamProgram::largestShift)
        return tr("D7 to D0: cams 7 to 0. No part of the position. D31: not valid.");
    const int highest = std::min(m_positionBits - 1, *lowest + lastPartBit - firstPartBit);
    return tr("D24 to D8: bits %1 to %2 of the position. D7 to D0: cams 7 to 0. D31: not valid.")
        .arg(highest)
        .arg(*lowest);
}

int CamWordPicture::cellWidth() const
{
    return std::clamp((width() - 1 - 3 * grid::groupGap) / bits, narrowestCell, widestCell);
}

QRect CamWordPicture::cellOf(int bit) const
{
    const int column = bits - 1 - bit;
    const int gaps = (bit < bits - 1 ? 1 : 0) + (bit <= lastPartBit ? 1 : 0) + (bit < firstPartBit ? 1 : 0);
    const int top = QFontMetrics(numberFont(TextSize::small)).height();
    return {column * cellWidth() + gaps * grid::groupGap, top, cellWidth(), top + 2 * grid::unit};
}

QSize CamWordPicture::sizeHint() const
{
    const int text = fontMetrics().height();
    return {bits * widestCell + 3 * grid::groupGap + 1, cellOf(0).bottom() + text + 2 * grid::unit};
}

QSize CamWordPicture::minimumSizeHint() const
{
    return {bits * narrowestCell + 3 * grid::groupGap + 1, sizeHint().height()};
}

void CamWordPicture::drawBit(QPainter &painter, int bit, const QRect &cell) const
{
    const auto part = positionBit(bit);
    const bool isCam = bit < firstPartBit;
    const bool isSaid = isCam || part || bit == bits - 1;
    QColor fill = roleColor(isCam ? Role::setBit : Role::inactive, palette());
    fill.setAlpha(isCam ? 255 : 60);
    painter.setPen(roleColor(Role::inactive, palette()));
    painter.setBrush(isSaid && bit != bits - 1 ? QBrush(fill) : QBrush(palette().color(QPalette::Base)));
    painter.drawRect(cell.adjusted(0, 0, -1, -1));
    painter.setFont(numberFont(TextSize::small));
    painter.setPen(isCam ? textOn(Role::setBit, palette())
                         : palette().color(isSaid ? QPalette::Text : QPalette::PlaceholderText));
    const QString content = isCam             ? QString::number(bit)
                            : part            ? QString::number(*part)
                            : bit == bits - 1 ? QStringLiteral("!")
                                              : QStringLiteral("0");
    painter.drawText(cell, Qt::AlignCenter, content);
}

void CamWordPicture::drawBrace(QPainter &painter, int highest, int lowest, const QString &text) const
{
    const QRect first = cellOf(highest);
    const QRect last = cellOf(lowest);
    const int y = first.bottom() + grid::unit;
    painter.setPen(roleColor(Role::inactive, palette()));
    painter.drawLine(first.left(), y, last.right(), y);
    painter.drawLine(first.left(), y - 2, first.left(), y);
    painter.drawLine(last.right(), y - 2, last.right(), y);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.setFont(textFont(TextSize::small));
    const int wide = painter.fontMetrics().horizontalAdvance(text);
    const int middle = (first.left() + last.right()) / 2;
    const int left = std::clamp(middle - wide / 2, 0, std::max(0, width() - wide));
    painter.drawText(QPoint(left, y + 2 + painter.fontMetrics().ascent()), text);
}

void CamWordPicture::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(numberFont(TextSize::small));
    painter.setPen(palette().color(QPalette::WindowText));
    for (const int bit : {31, 30, 25, 24, 16, 8, 7, 0}) {
        const QRect cell = cellOf(bit);
        painter.drawText(QRect(cell.left() - grid::unit, 0, cell.width() + 2 * grid::unit, cell.top()),
                         Qt::AlignCenter, QString::number(bit));
    }
    for (int bit = 0; bit < bits; ++bit)
        drawBit(painter, bit, cellOf(bit));
    drawBrace(painter, 31, 25, tr("! not valid"));
    drawBrace(painter, lastPartBit, firstPartBit,
              positionBit(firstPartBit) ? tr("bits of the position") : tr("no part of the position"));
    drawBrace(painter, 7, 0, tr("cams"));
}

} // namespace codewheel
