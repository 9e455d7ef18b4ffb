// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/dial_head.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/monitor/meaning_line.h"

#include <QToolButton>

namespace codewheel {

DialHead::DialHead(QWidget *parent)
    : QWidget(parent)
    , m_title(named(new MeaningLine(this), "dialTitle"))
    , m_pin(named(new QToolButton(this), "pinDial"))
{
    m_pin->setAccessibleName(tr("Pin dial"));
    m_pin->setIcon(lineIcon(Icon::pin));
    m_pin->setText(tr("Pinned", "the dial"));
    m_pin->setCheckable(true);
    m_pin->setAutoRaise(true);
    m_pin->setFocusPolicy(Qt::StrongFocus);
    layOutRow(this, {{m_title, 1}, m_pin}, {.spacing = grid::unit, .margins = QMargins()});
    connect(m_pin, &QToolButton::clicked, this, &DialHead::pinToggled);
    setTitle({});
    setPinned(false);
}

void DialHead::setTitle(const QString &title)
{
    m_title->setText(title);
    m_pin->setEnabled(!title.isEmpty());
}

void DialHead::setPinned(bool pinned)
{
    m_pin->setChecked(pinned);
    m_pin->setToolButtonStyle(pinned ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    m_pin->setToolTip(pinned ? tr("Let the dial follow the bus structure again")
                             : tr("Keep this dial when another encoder is chosen"));
}

bool DialHead::isPinned() const
{
    return m_pin->isChecked();
}

} // namespace codewheel
