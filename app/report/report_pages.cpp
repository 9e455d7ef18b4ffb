// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report_pages.h"

#include "app/report/report_document.h"
#include "app/report/sheet_format.h"
#include "report/printable_text.h"
#include "vocabulary/sentence.h"

#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

namespace codewheel {
namespace {

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
