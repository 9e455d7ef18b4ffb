// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include <initializer_list>

namespace codewheel {

// Keys that a view handles itself, without an action, as described to the user.
struct KeyHelp
{
    QString keys; // translated: "Left, Right"
    QString what;
};

// Keys that belong together: those of a menu, or those that work in one view.
struct KeyGroup
{
    QString title;
    QList<KeyHelp> rows;
};

inline QString keyNames(std::initializer_list<QKeySequence> keys)
{
    QStringList names;
    for (const QKeySequence &key : keys)
        names << key.toString(QKeySequence::NativeText);
    return names.join(QStringLiteral(", "));
}

} // namespace codewheel
