// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/note_bar.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr int longestNote = 200; // characters

} // namespace

NoteBar::NoteBar(QWidget *parent)
    : QWidget(parent)
    , m_where(new QLabel(this))
    , m_text(new QLineEdit(this))
{
    auto *take = new QPushButton(tr("&Set note"), this);
    auto *cancel = new QPushButton(tr("Cancel"), this);
    describe(take, "setNote", tr("Marks this moment with the text; an empty text removes the note (Return)"));
    describe(cancel, "cancelNote", tr("Changes nothing (Esc)"));
    describe(m_text, "noteText", tr("Text of the note"), tr("What happened at this moment"));
    m_text->setMaxLength(longestNote);
    layOutRow(this, {m_where, {m_text, 1}, take, cancel}, {.spacing = grid::unit, .margins = QMargins()});
    connect(m_text, &QLineEdit::returnPressed, this, [this] { end(true); });
    connect(take, &QPushButton::clicked, this, [this] { end(true); });
    connect(cancel, &QPushButton::clicked, this, [this] { end(false); });
    hide();
}

void NoteBar::ask(Instant at, const QString &moment, const QString &before)
{
    m_at = at;
    m_where->setText(tr("Note at %1:", "a time of day").arg(moment));
    m_text->setText(before);
    show();
    m_text->setFocus();
    m_text->selectAll();
}

void NoteBar::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        end(false);
    else
        QWidget::keyPressEvent(event);
}

void NoteBar::end(bool isTaken)
{
    hide();
    if (isTaken)
        Q_EMIT noted(m_at, m_text->text().simplified());
    Q_EMIT closed();
}

} // namespace codewheel
