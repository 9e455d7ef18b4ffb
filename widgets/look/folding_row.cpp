// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/folding_row.h"

#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QBoxLayout>
#include <QEvent>

#include <algorithm>

namespace codewheel {

FoldingRow::FoldingRow(QWidget *first, QWidget *second, QWidget *parent)
    : QWidget(parent)
    , m_first(first)
    , m_second(second)
    , m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this))
{
    m_layout->setContentsMargins({});
    m_layout->setSpacing(grid::margin);
    m_layout->addWidget(first, 1, Qt::AlignTop);
    m_layout->addWidget(second, 0);
    onEvent(this, {QEvent::Resize}, [this] { fold(); });
}

int FoldingRow::least(const QWidget &part) const
{
    return std::max(part.minimumSizeHint().width(), part.minimumWidth());
}

QSize FoldingRow::minimumSizeHint() const
{
    return {std::max(least(*m_first), least(*m_second)), QWidget::minimumSizeHint().height()};
}

// A part may need more or less room than before.
bool FoldingRow::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest)
        fold();
    return QWidget::event(event);
}

void FoldingRow::fold()
{
    const bool hasRoom = width() >= least(*m_first) + grid::margin + least(*m_second);
    m_layout->setDirection(hasRoom ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

} // namespace codewheel
