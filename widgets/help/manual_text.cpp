// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual_text.h"

#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QPalette>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

namespace codewheel {
namespace {

// Lower case; letters, digits, - and _ stay, spaces become -, everything else is dropped.
QString slug(const QString &title)
{
    QString slug;
    for (const QChar each : title.toLower())
        if (each.isLetterOrNumber() || each == u'-' || each == u'_')
            slug += each;
        else if (each.isSpace())
            slug += u'-';
    return slug;
}

void formatHeading(const QTextBlock &block)
{
    QTextBlockFormat format = block.blockFormat();
    format.setTopMargin(block.blockNumber() == 0 ? 0 : 3 * grid::margin);
    format.setBottomMargin(grid::margin);
    QTextCursor(block).setBlockFormat(format);
}

// A line of code that is too long wraps, so that the page stays as wide as the window.
void formatCode(const QTextBlock &block)
{
    const bool isCode = block.blockFormat().nonBreakableLines();
    if (isCode) {
        QTextBlockFormat format = block.blockFormat();
        format.setNonBreakableLines(false);
        format.setLeftMargin(2 * grid::margin);
        QTextCursor(block).setBlockFormat(format);
    }
    std::vector<std::pair<int, int>> spans; // collected before any is changed, since fragments then merge
    for (auto part = block.begin(); !part.atEnd(); ++part)
        if (const QTextFragment text = part.fragment(); isCode || text.charFormat().fontFixedPitch())
            spans.emplace_back(text.position(), text.position() + text.length());
    QTextCharFormat format;
    format.setFontFamilies({numberFont().family()});
    QTextCursor cursor(block);
    for (const auto &[begin, end] : spans) {
        cursor.setPosition(begin);
        cursor.setPosition(end, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(format);
    }
}

bool isEmptyRow(const QTextTable &table, int row)
{
    for (int column = 0; column < table.columns(); ++column)
        if (const QTextTableCell cell = table.cellAt(row, column);
            cell.firstPosition() != cell.lastPosition())
            return false;
    return true;
}

void formatTable(QTextTable &table, const QPalette &palette)
{
    QTextTableFormat format = table.format();
    format.setBorder(1);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(palette.brush(QPalette::Mid));
    format.setCellPadding(grid::unit);
    format.setCellSpacing(0);
    format.setTopMargin(grid::margin);
    format.setBottomMargin(grid::margin);
    table.setFormat(format);
    if (table.rows() > 1 && isEmptyRow(table, 0)) // Markdown has no table without a header
        table.removeRows(0, 1);
}

} // namespace

QString unusedAnchor(const QString &heading, const QSet<QString> &used)
{
    const QString first = slug(heading);
    QString free = first;
    for (int i = 1; used.contains(free); ++i)
        free = QStringLiteral("%1-%2").arg(first).arg(i);
    return free;
}

void nameHeadings(QTextDocument &document)
{
    QSet<QString> used;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0)
            continue;
        const QString anchor = unusedAnchor(block.text(), used);
        used.insert(anchor);
        QTextCharFormat format;
        format.setAnchor(true);
        format.setAnchorNames({anchor});
        QTextCursor cursor(block);
        cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(format);
    }
}

QString anchorOf(const QTextBlock &heading)
{
    return heading.begin().atEnd() ? QString()
                                   : heading.begin().fragment().charFormat().anchorNames().value(0);
}

void formatManual(QTextDocument &document, const QPalette &palette)
{
    QTextCursor all(&document);
    all.beginEditBlock(); // laid out once
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() > 0)
            formatHeading(block);
        formatCode(block);
    }
    for (QTextFrame *frame : document.rootFrame()->childFrames())
        if (auto *table = qobject_cast<QTextTable *>(frame))
            formatTable(*table, palette);
    QTextFrameFormat page = document.rootFrame()->frameFormat();
    page.setRightMargin(document.documentMargin() + manualSlant);
    document.rootFrame()->setFrameFormat(page);
    all.endEditBlock();
}

} // namespace codewheel
