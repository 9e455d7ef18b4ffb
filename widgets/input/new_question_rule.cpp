// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/new_question_rule.h"

#include <QAbstractButton>
#include <QDialog>
#include <QKeyEvent>

namespace codewheel {
namespace {

// Enter, Space, a letter.
bool mayAnswer(const QKeyEvent &key)
{
    return key.key() != Qt::Key_Escape && !key.text().isEmpty() && !(key.modifiers() & Qt::ControlModifier);
}

} // namespace

bool NewQuestionRule::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Show:
        noteShown(watched);
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Shortcut:
        return isAnswer(watched) && m_press.isSecond();
    case QEvent::KeyPress:
        return mayAnswer(*static_cast<QKeyEvent *>(event)) && isAnswer(watched) && m_press.isSecond();
    default:
        return false;
    }
}

void NewQuestionRule::noteShown(QObject *watched)
{
    auto *dialog = qobject_cast<QDialog *>(watched);
    if (dialog == nullptr || !dialog->isModal())
        return;
    m_question = dialog;
    m_press.begin();
}

bool NewQuestionRule::isAnswer(const QObject *watched) const
{
    if (!m_question || !watched->isWidgetType())
        return false;
    if (watched == m_question)
        return true;
    const auto *button = qobject_cast<const QAbstractButton *>(watched);
    return button != nullptr && button->window() == m_question &&
           button->objectName() != QStringLiteral("alarmStop");
}

} // namespace codewheel
