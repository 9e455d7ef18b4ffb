// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/number_field.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace codewheel {

namespace {

constexpr int rightGap = 2; // as in a line edit

} // namespace

NumberField::NumberField(const QString &widest, QWidget *parent)
    : ValueWidget(parent)
    , m_widest(widest)
{
    setFont(numberFont());
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    auto *copying = new QAction(tr("Copy this number"), this);
    connect(copying, &QAction::triggered, this, &NumberField::copy);
    addAction(copying);
}

void NumberField::showText(const QString &text)
{
    if (m_text == text)
        return;
    const QString before = std::exchange(m_text, text);
    if (before.size() != text.size()) {
        update(textRect());
        return;
    }
    const auto first = std::mismatch(text.begin(), text.end(), before.begin()).first - text.begin();
    update(cells(static_cast<int>(first), static_cast<int>(text.size())).toAlignedRect());
}

// The cells of the characters [first, end). The advance of a character may be a fraction of a pixel.
QRectF NumberField::cells(int first, int end) const
{
    const QRectF all = textRect();
    const double width = QFontMetricsF(font()).horizontalAdvance(QLatin1Char('0'));
    const auto length = static_cast<int>(m_text.size());
    return {all.right() - rightGap - (length - first) * width, all.top(), (end - first) * width,
            all.height()};
}

QStyleOptionFrame NumberField::frame() const
{
    QStyleOptionFrame option;
    option.initFrom(this);
    option.lineWidth = style()->pixelMetric(QStyle::PM_DefaultFrameWidth, &option, this);
    option.state |= QStyle::State_Sunken | QStyle::State_ReadOnly;
    return option;
}

void NumberField::copy() const
{
    QApplication::clipboard()->setText(m_text);
}

// As high as the line edit beside it.
QSize NumberField::sizeHint() const
{
    const QStyleOptionFrame option = frame();
    const QSize contents(fontMetrics().horizontalAdvance(m_widest) + 4 * grid::unit,
                         std::max(fontMetrics().height(), 14) + 2);
    const QSize size = style()->sizeFromContents(QStyle::CT_LineEdit, &option, contents, this);
    return {contents.width(), size.height()};
}

QRect NumberField::textRect() const
{
    return rect().adjusted(grid::unit, grid::unit - 1, -grid::unit, 1 - grid::unit);
}

void NumberField::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    const QRect exposed = event->rect();
    if (textRect().contains(exposed)) {
        painter.fillRect(exposed, palette().base());
    } else {
        const QStyleOptionFrame option = frame();
        style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
    }
    int first = 0;
    const int length = static_cast<int>(m_text.size());
    while (first < length && cells(first, first + 1).right() < exposed.left())
        ++first;
    const QFontMetricsF metrics(font());
    const QRectF area = cells(first, length);
    const double baseLine =
        std::round(area.top() + (area.height() - metrics.height()) / 2 + metrics.ascent());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(area.left(), baseLine), m_text.mid(first));
}

// Takes precedence over the shortcut of the monitor, which copies the word.
bool NumberField::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent *>(event)->matches(QKeySequence::Copy)) {
        event->accept();
        return true;
    }
    return ValueWidget::event(event);
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        ValueWidget::keyPressEvent(event);
}

} // namespace codewheel
