// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

namespace codewheel {

// A text for comparing: small letters without accents. An umlaut and its spelling with e are the same, so
// "pruefen" and "prufen" both find "Prüfen".
QString foldedText(const QString &text);
QStringList foldedWords(const QString &typed);

// Begin and length of what the folded words match in a text, in order and without overlaps.
std::vector<std::pair<int, int>> marksOf(const QString &text, const QStringList &words);

} // namespace codewheel
