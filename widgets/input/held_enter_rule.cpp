// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/held_enter_rule.h"

#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace codewheel {

bool HeldEnterRule::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType())
        return false;
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isEnter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    const bool makesLines =
        qobject_cast<QPlainTextEdit *>(watched) != nullptr || qobject_cast<QTextEdit *>(watched) != nullptr;
    return isEnter && key->isAutoRepeat() && !makesLines;
}

} // namespace codewheel
