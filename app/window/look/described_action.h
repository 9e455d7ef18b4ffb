// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/describe.h"
#include "widgets/look/label_text.h"

#include <QAction>

namespace codewheel {

// Sets its key, and what it does: in the status line, and in the tooltip followed by the key. Further keys of
// the action stay while this one does.
inline QAction *described(QAction *action, const QKeySequence &key, const QString &what)
{
    if (action->shortcut() != key)
        action->setShortcut(key);
    action->setStatusTip(what);
    action->setToolTip(
        key.isEmpty() ? what : QStringLiteral("%1 (%2)").arg(what, key.toString(QKeySequence::NativeText)));
    return action;
}

// The bus it applies to: after its text, before what it does; empty: as described.
inline void tellBus(QAction *action, const QString &bus)
{
    static constexpr const char *plain = "textWithoutBus";
    static constexpr const char *plainTip = "tipWithoutBus";
    if (!action->property(plain).isValid()) {
        action->setProperty(plain, action->text());
        action->setProperty(plainTip, action->statusTip());
    }
    const QString text = action->property(plain).toString();
    const QString tip = action->property(plainTip).toString();
    action->setText(bus.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, asLabel(bus)));
    described(action, action->shortcut(), bus.isEmpty() ? tip : QStringLiteral("%1: %2").arg(bus, tip));
}

inline QAction *checkable(QAction *action)
{
    action->setCheckable(true);
    return action;
}

} // namespace codewheel
