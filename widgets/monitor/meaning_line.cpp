// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/meaning_line.h"

#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace codewheel {

MeaningLine::MeaningLine(QWidget *parent, Qt::Alignment side)
    : QWidget(parent)
    , m_side(side)
{
    allowEliding(*this);
    setAutoFillBackground(true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void MeaningLine::setText(const QString &text)
{
    if (m_text == text)
        return;
    m_text = text;
    setAccessibleName(text);
    update();
}

QSize MeaningLine::sizeHint() const
{
    return {0, fontMetrics().height() + grid::unit};
}

bool MeaningLine::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const bool isElided = fontMetrics().horizontalAdvance(m_text) > width();
        QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), isElided ? m_text : QString(),
                           this);
        return true;
    }
    return QWidget::event(event);
}

void MeaningLine::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.drawText(rect(), static_cast<int>(m_side | Qt::AlignVCenter),
                     fontMetrics().elidedText(m_text, Qt::ElideRight, width()));
}

} // namespace codewheel
