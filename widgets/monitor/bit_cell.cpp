// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/bit_cell.h"

#include "widgets/look/fonts.h"
#include "widgets/look/roles.h"

#include <QPainter>

namespace codewheel {

namespace {

constexpr qreal cellRadius = 3;
constexpr qreal changeMarkSize = 5;

std::size_t indexOf(BitCell cell)
{
    return (cell.set ? 1U : 0U) | (cell.changed ? 2U : 0U) | (cell.staged ? 4U : 0U) |
           (cell.focused ? 8U : 0U) | (cell.hovered ? 16U : 0U) | (cell.enabled ? 32U : 0U);
}

class CellPainter
{
public:
    CellPainter(QPixmap &pixmap, QSize size, BitCell cell, const QPalette &palette)
        : m_painter(&pixmap)
        , m_cell(cell)
        , m_palette(palette)
        , m_text(palette.color(cell.enabled ? QPalette::Active : QPalette::Disabled, QPalette::Text))
        , m_fill(roleColor(cell.enabled ? Role::setBit : Role::inactive, palette))
        , m_box(QRectF(QPointF(), size).adjusted(1, 1, -1, -1))
    {
        m_painter.setRenderHint(QPainter::Antialiasing);
        if (cell.focused)
            drawRing();
        drawBox();
        if (cell.changed)
            drawMark();
        drawDigit();
    }

private:
    void drawRing()
    {
        m_painter.setPen(QPen(m_text, 2));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRoundedRect(m_box, cellRadius + 1, cellRadius + 1);
        m_box.adjust(2.5, 2.5, -2.5, -2.5);
    }

    void drawBox()
    {
        const QRectF line = m_box.adjusted(0.5, 0.5, -0.5, -0.5);
        m_painter.setBrush(m_palette.color(QPalette::Base));
        m_painter.setPen(Qt::NoPen);
        m_painter.drawRoundedRect(m_box, cellRadius, cellRadius);
        if (m_cell.set) {
            const qreal inset = m_cell.staged ? 2.5 : 0;
            m_painter.setBrush(m_fill);
            m_painter.drawRoundedRect(m_box.adjusted(inset, inset, -inset, -inset), cellRadius - inset / 2,
                                      cellRadius - inset / 2);
        }
        m_painter.setBrush(Qt::NoBrush);
        if (m_cell.staged) {
            QPen pen(m_text, 1.5);
            pen.setDashPattern({2, 1.5});
            pen.setCapStyle(Qt::FlatCap);
            m_painter.setPen(pen);
            m_painter.drawRoundedRect(line, cellRadius, cellRadius);
        } else if (m_cell.hovered) {
            m_painter.setPen(QPen(m_text, 1.5));
            m_painter.drawRoundedRect(line, cellRadius, cellRadius);
        } else if (!m_cell.set) {
            m_painter.setPen(QPen(roleColor(Role::inactive, m_palette), 1));
            m_painter.drawRoundedRect(line, cellRadius, cellRadius);
        }
    }

    void drawMark()
    {
        const qreal inset = m_cell.staged ? 4 : 2;
        const QPointF corner = m_box.topRight() + QPointF(-inset, inset);
        const std::array points{corner, corner - QPointF(changeMarkSize, 0),
                                corner + QPointF(0, changeMarkSize)};
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(inkOnBox());
        m_painter.drawPolygon(points.data(), static_cast<int>(points.size()));
    }

    void drawDigit()
    {
        QFont font = numberFont();
        font.setBold(m_cell.set);
        m_painter.setFont(font);
        m_painter.setPen(inkOnBox());
        m_painter.drawText(m_box, Qt::AlignCenter, m_cell.set ? QStringLiteral("1") : QStringLiteral("0"));
    }

    QColor inkOnBox() const
    {
        if (m_cell.set)
            return textOn(m_cell.enabled ? Role::setBit : Role::inactive, m_palette);
        return m_text;
    }

    QPainter m_painter;
    BitCell m_cell;
    const QPalette &m_palette;
    QColor m_text;
    QColor m_fill;
    QRectF m_box;
};

} // namespace

const QPixmap &BitCellPictures::picture(BitCell cell, QSize size, qreal scale, const QPalette &palette)
{
    if (size != m_size || !qFuzzyCompare(scale, m_scale)) {
        clear();
        m_size = size;
        m_scale = scale;
    }
    QPixmap &picture = m_pictures.at(indexOf(cell));
    if (picture.isNull()) {
        picture = QPixmap((QSizeF(size) * scale).toSize());
        picture.setDevicePixelRatio(scale);
        picture.fill(Qt::transparent);
        const CellPainter painted(picture, size, cell, palette);
    }
    return picture;
}

void BitCellPictures::clear()
{
    m_pictures.fill({});
}

} // namespace codewheel
