// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

namespace codewheel {

// Fonts of the report on paper.
struct ReportFonts
{
    ReportFonts();

    QFont title;
    QFont chapter;
    QFont part;
    QFont text;
    QFont cell;
    QFont stressedCell;
    QFont codeCell;
    QFont small; // head, foot, captions
};

qreal lineHeight(const QFont &font);
qreal textWidth(const QString &text, const QFont &font);

// The text in lines of at most this width, broken between words, or within one that is wider. At least one
// line.
QStringList textLines(const QString &text, const QFont &font, qreal width);

} // namespace codewheel
