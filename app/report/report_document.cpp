// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_document.h"

#include "app/report/column_widths.h"
#include "app/report/sheet_format.h"
#include "app/report/svg_picture.h"
#include "report/html_report.h"
#include "report/html_style.h"

#include <QAbstractTextDocumentLayout>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QScreen>
#include <QTextCursor>
#include <QTextTable>

namespace codewheel {
namespace {

// Text documents know screen pixels, but no millimetres.
QString styleInPixels()
{
    static const QRegularExpression length(QStringLiteral("(\\d+|\\d*\\.\\d+)mm"));
    const QScreen *screen = QGuiApplication::primaryScreen();
    const double perMillimetre = (screen ? qRound(screen->logicalDotsPerInchY()) : 100) / 25.4;
    QString style = QString::fromLatin1(reportStyle);
    for (auto match = length.match(style); match.hasMatch(); match = length.match(style))
        style.replace(match.capturedStart(), match.capturedLength(),
                      QString::number(match.captured(1).toDouble() * perMillimetre, 'f', 2) +
                          QStringLiteral("px"));
    return style;
}

QFont baseFont()
{
    QFont font;
    font.setHintingPreference(QFont::PreferNoHinting);
    // No ligatures ("fi"), so that words are found in the PDF; scripts that need shaping get it anyway.
    font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

QString pictureElement(const CamPicture &picture)
{
    return QStringLiteral("<p><img src=\"") +
           QString::fromLatin1(camPictureAsSvg(picture).toUtf8().toBase64()) + QStringLiteral("\"/></p>");
}

// In percent of the sheet. A header may wrap between its words, other cells should not.
qreal wantedWidth(const QTextTableCell &cell, bool isHeader, QPaintDevice &device)
{
    QTextCursor text = cell.firstCursorPosition();
    text.setPosition(cell.lastPosition(), QTextCursor::KeepAnchor);
    const QFontMetricsF metrics(text.charFormat().font(), &device);
    qreal widest = 0;
    for (const QString &part :
         text.selectedText().split(isHeader ? QChar(u' ') : QChar(QChar::LineSeparator)))
        widest = std::max(widest, metrics.horizontalAdvance(part));
    return 100 * (widest + sheet::columnGap) / sheet::body.width();
}

std::vector<qreal> columnsOf(const QTextTable &table, QPaintDevice &device)
{
    const int headers = table.format().headerRowCount();
    if (headers == 0 && table.columns() == 2) // facts
        return {23, 77};
    if (headers == 0) // places to sign, with gaps
        return {36, 4, 20, 4, 36};
    std::vector<qreal> wanted(static_cast<std::size_t>(table.columns()));
    for (int row = 0; row < table.rows(); ++row)
        for (int column = 0; column < table.columns(); ++column) {
            qreal &width = wanted[static_cast<std::size_t>(column)];
            width = std::max(width, wantedWidth(table.cellAt(row, column), row < headers, device));
        }
    return columnWidths(wanted, 100);
}

void setWidths(QTextTable &table, QPaintDevice &device)
{
    QList<QTextLength> columns;
    for (const qreal width : columnsOf(table, device))
        columns.push_back(QTextLength(QTextLength::PercentageLength, width));
    QTextTableFormat format = table.format();
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    format.setColumnWidthConstraints(columns);
    // A block after a table gets no margin of its own.
    format.setBottomMargin(table.lastCursorPosition().block().next().blockFormat().topMargin());
    table.setFormat(format);
}

} // namespace

std::unique_ptr<QTextDocument> reportDocument(const Report &report, QPaintDevice &device)
{
    auto document = std::make_unique<QTextDocument>();
    document->documentLayout()->setPaintDevice(&device);
    document->documentLayout()->registerHandler(QTextFormat::ImageObject, new SvgPicture(document.get()));
    document->setDocumentMargin(0);
    document->setDefaultFont(baseFont());
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    document->setDefaultTextOption(option);
    document->setDefaultStyleSheet(styleInPixels());
    document->setHtml(reportBody(report, pictureElement));
    QTextCursor all(document.get());
    all.beginEditBlock();
    for (QTextFrame *frame : document->rootFrame()->childFrames())
        if (auto *table = qobject_cast<QTextTable *>(frame))
            setWidths(*table, device);
    all.endEditBlock();
    document->setTextWidth(sheet::body.width()); // lays out all of it again
    return document;
}

} // namespace codewheel
