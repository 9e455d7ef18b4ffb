// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QJsonObject;

namespace codewheel {

struct Terminal;

// The one list of an answer in JSON that is printed as it comes, so that however long it gets nothing waits
// in memory: a line for each entry. What else is in the object follows as Answer::json, with hasBegunJson.
class JsonList
{
public:
    JsonList(const Terminal &terminal, const QString &key);
    ~JsonList();
    Q_DISABLE_COPY_MOVE(JsonList)

    void add(const QJsonObject &entry);

private:
    const Terminal &m_terminal;
    bool m_isEmpty = true;
};

} // namespace codewheel
