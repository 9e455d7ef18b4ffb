// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/content_scroll_area.h"

#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QResizeEvent>
#include <QScrollBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int lowest = 12 * grid::unit; // a line and part of the next, which shows that there is more

} // namespace

ContentScrollArea::ContentScrollArea(QWidget *content, QWidget *parent)
    : QScrollArea(parent)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setFocusPolicy(Qt::NoFocus); // the content takes the keys
    setWidget(content);
    // A content without a layout, like a label, tells its parent.
    for (QWidget *part : {content, viewport()})
        onEventOf(part, {QEvent::LayoutRequest}, this, [this] { updateGeometry(); });
}

QSize ContentScrollArea::sizeHint() const
{
    const QSize content = widget()->sizeHint();
    const bool wraps = m_hasWidth && widget()->hasHeightForWidth();
    return {content.width(), wraps ? widget()->heightForWidth(viewport()->width()) : content.height()};
}

QSize ContentScrollArea::minimumSizeHint() const
{
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            std::min(lowest, sizeHint().height())};
}

// At another width, lines wrap at other places.
void ContentScrollArea::resizeEvent(QResizeEvent *event)
{
    QScrollArea::resizeEvent(event);
    m_hasWidth = true;
    if (event->size().width() != event->oldSize().width())
        updateGeometry();
}

} // namespace codewheel
