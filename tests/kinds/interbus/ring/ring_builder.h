// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"

#include <QStringList>

namespace codewheel::test {

// Rings in short notation: "1.0", "2.0 T" a bus terminal, "2.1", "3.0 T 1" on level 1.
inline RingDevice participant(const QString &text)
{
    const QStringList parts = text.split(u' ');
    const bool isTerminal = parts.contains(QStringLiteral("T"));
    RingDevice made{.number = NodeId(parts.first().toStdString()),
                    .deviceCode = isTerminal ? busTerminalIdCode : 0x0237,
                    .inWords = isTerminal ? 0 : 2,
                    .outWords = isTerminal ? 0 : 2,
                    .deviceKey = {}};
    if (parts.size() > 1 && parts.last() != QStringLiteral("T"))
        made.level = parts.last().toInt();
    return made;
}

inline RingStructure ring(const QStringList &texts)
{
    RingStructure structure;
    for (const QString &text : texts)
        structure.push_back(participant(text));
    return structure;
}

inline QStringList texts(const RingStructure &structure)
{
    QStringList texts;
    for (const RingDevice &device : structure) {
        QString text = device.number.toString();
        if (device.idCode() == busTerminalIdCode)
            text += QStringLiteral(" T");
        if (device.level > 0)
            text += u' ' + QString::number(device.level);
        texts << text;
    }
    return texts;
}

// A main line with a terminal that has a local bus and a branch, which in turn has a terminal.
inline QStringList plant()
{
    return {QStringLiteral("1.0"),   QStringLiteral("2.0 T"), QStringLiteral("2.1"),
            QStringLiteral("2.2"),   QStringLiteral("3.0 1"), QStringLiteral("4.0 T 1"),
            QStringLiteral("4.1 1"), QStringLiteral("5.0 2"), QStringLiteral("6.0 1"),
            QStringLiteral("7.0"),   QStringLiteral("8.0 T"), QStringLiteral("9.0")};
}

} // namespace codewheel::test
