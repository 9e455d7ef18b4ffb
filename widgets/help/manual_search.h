// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QUrl>

#include <vector>

namespace codewheel {

class Manual;

// A section of the manual in which all words of a search stand.
struct ManualHit
{
    QUrl url; // with its anchor
    QString page;
    QString section;
    QString excerpt; // one line around the first word
};

// "zero offset" has two words, "\"zero offset\"" one.
QStringList searchedWords(const QString &typed);

// Those with a word in their heading first, then as the pages have them. Capitals do not matter.
std::vector<ManualHit> searchManual(const Manual &manual, const QStringList &words);

} // namespace codewheel
