// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/text_lines.h"

#include "pdf/sheet_format.h"
#include "report/printable_text.h"

#include <QFontMetricsF>
#include <QTextLayout>

namespace codewheel {
namespace {

QFont fontOf(const QString &family, QFont::StyleHint hint, qreal points, bool bold = false)
{
    QFont font(family);
    font.setStyleHint(hint);
    font.setPixelSize(qRound(sheet::point(points)));
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting);
    // No ligatures ("fi"), so that words are found in the PDF; scripts that need shaping get it anyway.
    font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

QFont sans(qreal points, bool bold = false)
{
    return fontOf(QStringLiteral("sans-serif"), QFont::SansSerif, points, bold);
}

} // namespace

ReportFonts::ReportFonts()
    : title(sans(18, true))
    , chapter(sans(13, true))
    , part(sans(11, true))
    , text(sans(9.5))
    , cell(sans(8))
    , stressedCell(sans(8, true))
    , codeCell(fontOf(QStringLiteral("monospace"), QFont::Monospace, 8))
    , small(sans(7.5))
{}

qreal lineHeight(const QFont &font)
{
    return QFontMetricsF(font).height();
}

qreal textWidth(const QString &text, const QFont &font)
{
    return QFontMetricsF(font).horizontalAdvance(text);
}

QStringList textLines(const QString &text, const QFont &font, qreal width)
{
    QString shown = printableText(text);
    shown.replace(u'\t', u' ').replace(u'\n', QChar::LineSeparator);
    QTextLayout layout(shown, font);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);

    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        lines << shown.mid(line.textStart(), line.textLength()).remove(QChar::LineSeparator).trimmed();
    }
    layout.endLayout();
    return lines.isEmpty() ? QStringList(QString()) : lines;
}

} // namespace codewheel
