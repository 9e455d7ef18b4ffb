// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/json_list.h"

#include "cli/call/terminal.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace codewheel {

JsonList::JsonList(const Terminal &terminal, const QString &key)
    : m_terminal(terminal)
{
    m_terminal.print(QStringLiteral("{\n    \"%1\": [").arg(key));
}

void JsonList::add(const QJsonObject &entry)
{
    m_terminal.print((m_isEmpty ? QStringLiteral("\n        ") : QStringLiteral(",\n        ")) +
                     QString::fromUtf8(QJsonDocument(entry).toJson(QJsonDocument::Compact)));
    m_isEmpty = false;
}

JsonList::~JsonList()
{
    m_terminal.print(QStringLiteral("\n    ],"));
}

} // namespace codewheel
