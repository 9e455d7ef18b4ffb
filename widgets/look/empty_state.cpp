// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/empty_state.h"

#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace codewheel {

EmptyState::EmptyState(Icon icon, const QString &what, const QString &how, QWidget *parent)
    : QWidget(parent)
    , m_name(icon)
    , m_icon(new QLabel(this))
    , m_what(new QLabel(this))
    , m_how(new QLabel(this))
    , m_action(new QPushButton(this))
{
    for (QLabel *label : {m_what, m_how}) {
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignHCenter);
        label->setTextFormat(Qt::PlainText);
    }
    m_icon->setAlignment(Qt::AlignHCenter);
    m_action->hide();

    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(grid::margin);
    layout->addStretch(2);
    layout->addWidget(m_icon);
    layout->addWidget(m_what);
    layout->addWidget(m_how);
    layout->addSpacing(grid::unit);
    layout->addWidget(m_action, 0, Qt::AlignHCenter);
    layout->addStretch(3);

    connect(m_action, &QPushButton::clicked, this, &EmptyState::actionTriggered);
    setTexts(what, how);
    setFonts();
    drawIcon();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] { drawIcon(); });
}

void EmptyState::setTexts(const QString &what, const QString &how)
{
    m_what->setText(what);
    m_how->setText(how);
    m_how->setVisible(!how.isEmpty());
    setAccessibleName(what);
    setAccessibleDescription(how);
}

void EmptyState::setAction(const QString &text)
{
    m_action->setText(text);
    m_action->setToolTip(m_how->text());
    m_action->setVisible(!text.isEmpty());
    setFocusProxy(text.isEmpty() ? nullptr : m_action);
}

void EmptyState::drawIcon()
{
    const QSize size(grid::largeIcon, grid::largeIcon);
    m_icon->setPixmap(lineIcon(m_name).pixmap(size, devicePixelRatioF()));
}

void EmptyState::setFonts()
{
    QFont strong = font();
    strong.setBold(true);
    m_what->setFont(strong);
}

} // namespace codewheel
