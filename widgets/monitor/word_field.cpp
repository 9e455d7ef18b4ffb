// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_field.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QAction>
#include <QFocusEvent>
#include <QPainter>
#include <QStyle>

namespace codewheel {

WordField::WordField(const QString &widest, QWidget *parent)
    : QLineEdit(parent)
    , m_widest(widest)
{
    setFont(numberFont());
    setAlignment(Qt::AlignRight);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(this, &QLineEdit::textChanged, this, [this](const QString &text) {
        if (!m_shows)
            Q_EMIT typed(text);
    });
}

void WordField::showText(const QString &text)
{
    if (this->text() == text)
        return;
    m_shows = true;
    setText(text);
    m_shows = false;
}

void WordField::setProblem(const QString &sentence)
{
    if (m_problem == sentence)
        return;
    if (m_problem.isEmpty()) {
        m_toolTip = toolTip();
        m_mark = addAction(lineIcon(Icon::attention, Role::attention), LeadingPosition);
    }
    m_problem = sentence;
    if (m_problem.isEmpty()) {
        delete std::exchange(m_mark, nullptr);
        setToolTip(m_toolTip);
    } else {
        m_mark->setToolTip(sentence);
        setToolTip(sentence);
    }
    setAccessibleDescription(sentence);
    update();
}

QSize WordField::sizeHint() const
{
    const QSize own = QLineEdit::sizeHint();
    return {fontMetrics().horizontalAdvance(m_widest) + 4 * grid::unit, own.height()};
}

void WordField::focusInEvent(QFocusEvent *event)
{
    QLineEdit::focusInEvent(event);
    m_isClicked = event->reason() == Qt::MouseFocusReason;
}

void WordField::mouseReleaseEvent(QMouseEvent *event)
{
    QLineEdit::mouseReleaseEvent(event);
    if (std::exchange(m_isClicked, false) && !hasSelectedText())
        selectAll();
}

void WordField::paintEvent(QPaintEvent *event)
{
    QLineEdit::paintEvent(event);
    if (m_problem.isEmpty())
        return;
    QPainter painter(this);
    painter.setPen(QPen(roleColor(Role::attention, palette()), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

} // namespace codewheel
