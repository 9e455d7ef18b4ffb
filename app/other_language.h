// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>

namespace codewheel {

// The texts of the program in its other languages: who works with a German window may think of an action by
// its English name, and the other way round.
class OtherLanguage
{
public:
    // Of a label or a sentence as it is shown, without its mnemonic; empty: it is the same in all, or is put
    // together. The first call reads the translations that are built in.
    QString of(const QString &shown);

private:
    void read();

    bool m_isRead = false;
    QHash<QString, QStringList> m_others;
};

} // namespace codewheel
