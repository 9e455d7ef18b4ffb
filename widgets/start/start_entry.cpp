// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/start_entry.h"

#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_label.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>

namespace codewheel {

StartEntry::StartEntry(QAction &action, QWidget *parent)
    : QPushButton(parent)
    , m_action(action)
    , m_icon(new QLabel(this))
    , m_title(wrappedLabel(this))
    , m_sentence(wrappedLabel(this))
    , m_key(new QLabel(this))
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
    grid->setHorizontalSpacing(grid::margin);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_icon, 0, 0, 2, 1, Qt::AlignTop);
    grid->addWidget(m_title, 0, 1);
    grid->addWidget(m_sentence, 1, 1);
    grid->addWidget(m_key, 0, 2, 2, 1, Qt::AlignTop);
    grid->setColumnStretch(1, 1);
    QFont strong = font();
    strong.setBold(true);
    m_title->setFont(strong);
    for (QLabel *label : {m_icon, m_title, m_sentence, m_key}) {
        label->setTextFormat(Qt::PlainText);
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    setAutoDefault(true); // Return presses it, like Space
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    connect(&action, &QAction::changed, this, &StartEntry::follow);
    connect(this, &QPushButton::clicked, &action, &QAction::trigger);
    follow();
    onEvent(this, {QEvent::PaletteChange, QEvent::StyleChange}, [this] {
        m_icon->setPixmap(m_action.icon().pixmap({grid::largeIcon, grid::largeIcon}, devicePixelRatioF()));
    });
}

void StartEntry::follow()
{
    m_title->setText(m_action.text());
    m_sentence->setText(m_action.toolTip());
    m_key->setText(m_action.shortcut().toString(QKeySequence::NativeText));
    m_icon->setPixmap(m_action.icon().pixmap({grid::largeIcon, grid::largeIcon}, devicePixelRatioF()));
    setAccessibleName(m_action.text());
    setToolTip(m_action.toolTip());
    setEnabled(m_action.isEnabled());
    setVisible(m_action.isVisible());
    updateGeometry();
}

QSize StartEntry::sizeHint() const
{
    return layout()->sizeHint();
}

QSize StartEntry::minimumSizeHint() const
{
    return layout()->minimumSize();
}

} // namespace codewheel
