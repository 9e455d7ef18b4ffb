// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/role_label.h"

#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"

#include <QHBoxLayout>
#include <QLabel>

namespace codewheel {

RoleLabel::RoleLabel(QWidget *parent)
    : QWidget(parent)
    , m_icon(new QLabel(this))
    , m_word(new QLabel(this))
{
    auto *layout = layOut<QHBoxLayout>(this, grid::unit);
    layout->addWidget(m_icon);
    layout->addWidget(m_word, 1);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    m_word->setText(roleWord(m_role));
    setAccessibleName(m_word->text());
    drawIcon();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] { drawIcon(); });
}

void RoleLabel::setWrapping()
{
    m_word->setWordWrap(true);
    layout()->setAlignment(m_icon, Qt::AlignTop);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void RoleLabel::setState(Role role, const QString &word)
{
    if (role == m_role && word == m_word->text())
        return; // called 30 times a second
    m_role = role;
    m_word->setText(word);
    setAccessibleName(word);
    drawIcon();
}

QString RoleLabel::word() const
{
    return m_word->text();
}

void RoleLabel::drawIcon()
{
    const QSize size(grid::smallIcon, grid::smallIcon);
    m_icon->setPixmap(lineIcon(roleIcon(m_role), m_role).pixmap(size, devicePixelRatioF()));
}

} // namespace codewheel
