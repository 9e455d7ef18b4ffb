// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/scrolled_panel.h"

#include "widgets/look/describe.h"

#include <QFormLayout>
#include <QLabel>
#include <QScrollBar>

#include <algorithm>

namespace codewheel {

ScrolledPanel::ScrolledPanel(const QString &name, int mostHeight, QWidget *parent)
    : QScrollArea(parent)
    , m_content(new QWidget(this))
    , m_mostHeight(mostHeight)
{
    setAccessibleName(name);
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setWidget(m_content);
}

QLabel *ScrolledPanel::addLine(QFormLayout &form, const QString &caption, const QString &toolTip)
{
    auto *value = describe(new QLabel(m_content), caption, toolTip);
    value->setTextFormat(Qt::PlainText);
    value->setWordWrap(true);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    form.addRow(caption, value);
    return value;
}

QSize ScrolledPanel::sizeHint() const
{
    const QSize wanted = m_content->sizeHint();
    return {wanted.width() + verticalScrollBar()->sizeHint().width(),
            std::min(wanted.height(), m_mostHeight)};
}

} // namespace codewheel
