// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include <initializer_list>

namespace codewheel {

// Keys that a view answers itself, without an action, as people are told of them.
struct KeyHelp
{
    QString keys; // in the words of the language: "Left, Right"
    QString what;
};

inline QString keyNames(std::initializer_list<QKeySequence> keys)
{
    QStringList names;
    for (const QKeySequence &key : keys)
        names << key.toString(QKeySequence::NativeText);
    return names.join(QStringLiteral(", "));
}

} // namespace codewheel
