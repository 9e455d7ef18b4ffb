// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/text_fields.h"

#include "widgets/input/form_focus.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPointer>

namespace codewheel {

TextField::TextField(QWidget *parent)
    : QLineEdit(parent)
{
    connect(this, &QLineEdit::textChanged, this, [this](const QString &text) {
        if (!isModified()) // set by code
            m_taken = text;
    });
    connect(this, &QLineEdit::editingFinished, this, &TextField::take);
}

void TextField::take()
{
    if (!isModified())
        return;
    setModified(false);
    if (text() == m_taken)
        return;
    m_taken = text();
    Q_EMIT taken(m_taken);
}

// The field handles Esc if something was typed; otherwise its surroundings do.
void TextField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && text() != m_taken) {
        setText(QString(m_taken));
        selectAll();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

NoteField::NoteField(QWidget *parent)
    : QPlainTextEdit(parent)
{
    setTabChangesFocus(true);
}

void NoteField::setTakenText(const QString &text)
{
    m_taken = text;
    if (toPlainText() != text)
        setPlainText(text);
}

void NoteField::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && toPlainText() != m_taken) {
        setPlainText(m_taken);
        return;
    }
    QPlainTextEdit::keyPressEvent(event);
}

void NoteField::focusOutEvent(QFocusEvent *event)
{
    QPlainTextEdit::focusOutEvent(event);
    if (toPlainText() == m_taken)
        return;
    m_taken = toPlainText();
    Q_EMIT taken(m_taken);
}

void takeFocusedField()
{
    const QPointer<QWidget> field = QApplication::focusWidget();
    if (!field)
        return;
    for (FormFocus *waiting : field->findChildren<FormFocus *>(QString(), Qt::FindDirectChildrenOnly))
        waiting->take();
    if (!field)
        return;
    field->clearFocus();
    if (field && field->isVisible()) // a cell's field is gone by now
        field->setFocus(Qt::OtherFocusReason);
}

} // namespace codewheel
