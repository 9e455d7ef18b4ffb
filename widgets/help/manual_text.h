// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QString>

class QPalette;
class QTextBlock;
class QTextDocument;

namespace codewheel {

// What a page of the manual lacks after Qt has read its Markdown.

// Gives each heading the anchor that links use, the same as on the web.
void nameHeadings(QTextDocument &document);
QString anchorOf(const QTextBlock &heading);
// That of the next heading of a page which has used these.
QString unusedAnchor(const QString &heading, const QSet<QString> &used);

// How far a slanted letter may lean out at the end of its line; pages have so much more margin on the right.
inline constexpr int manualSlant = 4; // px

// Tables with thin lines, room around headings, code in the program's fixed font.
void formatManual(QTextDocument &document, const QPalette &palette);

} // namespace codewheel
