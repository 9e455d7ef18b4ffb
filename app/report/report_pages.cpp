// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_pages.h"

#include "app/report/column_widths.h"
#include "app/report/sheet_format.h"
#include "app/report/svg_picture.h"
#include "report/html_report.h"
#include "report/html_style.h"
#include "report/printable_text.h"
#include "report/report.h"
#include "vocabulary/sentence.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QRegularExpression>
#include <QScreen>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

#include <memory>

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

// The report's web page as one long sheet, as wide as the body of a sheet, in dots of the device.
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

// The context of these texts.
struct ReportSheets
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ReportSheets)
};

QImage paperForMetrics()
{
    QImage image(1, 1, QImage::Format_Mono);
    image.setDotsPerMeterX(qRound(sheet::mm(1000)));
    image.setDotsPerMeterY(qRound(sheet::mm(1000)));
    return image;
}

void paintLine(QPainter &painter, qreal top, const QString &left, const QString &right)
{
    const qreal half = sheet::body.width() / 2 - sheet::columnGap;
    const QFontMetricsF metrics = painter.fontMetrics();
    const QRectF room(sheet::body.left(), top, sheet::body.width(), metrics.height());
    painter.drawText(room, Qt::AlignLeft, metrics.elidedText(left, Qt::ElideRight, half));
    painter.drawText(room, Qt::AlignRight, metrics.elidedText(right, Qt::ElideRight, half));
}

} // namespace

ReportPages::ReportPages(const Report &report)
    : m_title(report.title)
    , m_subject(printableText(report.subject).simplified())
    , m_origin(report.origin)
    , m_paper(paperForMetrics())
    , m_document(reportDocument(report, m_paper))
    , m_cuts(pageCuts(*m_document, sheet::body.height()))
{}

void ReportPages::paint(QPainter &painter, int page) const
{
    const PageCut &cut = m_cuts.at(static_cast<std::size_t>(page));
    if (!cut.header.isEmpty())
        paintPart(painter, cut.header, sheet::body.top());
    paintPart(painter, {0, cut.top, sheet::body.width(), cut.bottom - cut.top},
              sheet::body.top() + cut.header.height());
    paintHeadAndFoot(painter, page);
}

void ReportPages::paintPart(QPainter &painter, const QRectF &part, qreal top) const
{
    QAbstractTextDocumentLayout::PaintContext context;
    context.palette.setColor(QPalette::Text, Qt::black);
    context.clip = part;
    painter.save();
    painter.translate(sheet::body.left(), top - part.top());
    painter.setClipRect(part.adjusted(0, 0, 0, sheet::thinLine)); // including the line below a row
    m_document->documentLayout()->draw(&painter, context);
    painter.restore();
}

// The first sheet has the title instead of a header.
void ReportPages::paintHeadAndFoot(QPainter &painter, int page) const
{
    QFont font = m_document->defaultFont();
    font.setFamily(QStringLiteral("sans-serif"));
    font.setPixelSize(qRound(sheet::point(7.5)));
    painter.setFont(font);
    painter.setPen(Qt::black);
    if (page > 0)
        paintLine(painter, sheet::headLine, m_title, m_subject);
    paintLine(
        painter, sheet::footLine, m_origin,
        sentence(ReportSheets::tr("Page %1 of %2"), {QString::number(page + 1), QString::number(count())}));
}

} // namespace codewheel
