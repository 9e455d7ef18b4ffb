// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/undo_rule.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace codewheel {

bool UndoRule::eventFilter(QObject *watched, QEvent *event)
{
    const auto *field = qobject_cast<QLineEdit *>(watched);
    if (event->type() != QEvent::ShortcutOverride || field == nullptr)
        return false;
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isOfProject = (key->matches(QKeySequence::Undo) && !field->isUndoAvailable()) ||
                             (key->matches(QKeySequence::Redo) && !field->isRedoAvailable());
    if (isOfProject)
        event->ignore();
    return isOfProject;
}

} // namespace codewheel
