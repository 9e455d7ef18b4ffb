// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>

namespace codewheel {

// With its key, and what it does: in the status line, and in the tooltip with the key behind it.
inline QAction *described(QAction *action, const QKeySequence &key, const QString &what)
{
    action->setShortcut(key);
    action->setStatusTip(what);
    action->setToolTip(
        key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key.toString(QKeySequence::NativeText)));
    return action;
}

inline QAction *checkable(QAction *action)
{
    action->setCheckable(true);
    return action;
}

} // namespace codewheel
