// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QUrl>

#include <vector>

namespace codewheel {

class Manual;

// A section of the manual that contains all words of a search.
struct ManualHit
{
    QUrl url; // with its anchor
    QString page;
    QString section;
    QString excerpt; // one line around the first word
};

// "zero offset" has two words, "\"zero offset\"" one.
QStringList searchedWords(const QString &typed);

// Those with a word in their heading first, then in page order. Case does not matter.
std::vector<ManualHit> searchManual(const Manual &manual, const QStringList &words);

} // namespace codewheel
