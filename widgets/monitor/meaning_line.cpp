// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/meaning_line.h"

#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace codewheel {

namespace {

// Never within a word: of "7,967,178" no "7,967,1…" is left to be misread.
QString elidedAtWord(const QFontMetrics &metrics, const QString &text, int width)
{
    if (metrics.horizontalAdvance(text) <= width)
        return text;
    const QString cut = metrics.elidedText(text, Qt::ElideRight, width).chopped(1); // the dots
    const auto kept =
        text.size() > cut.size() && text.at(cut.size()) != u' ' ? cut.lastIndexOf(u' ') : cut.size();
    return kept > 0 ? cut.left(kept).trimmed() + QChar(0x2026) : cut + QChar(0x2026);
}

} // namespace

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
                     elidedAtWord(fontMetrics(), m_text, width()));
}

} // namespace codewheel
