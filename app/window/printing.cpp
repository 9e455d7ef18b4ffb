// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/printing.h"

#include "app/report/report_pages.h"
#include "app/report/sheet_format.h"
#include "app/window/printed_table.h"
#include "app/window/report_export.h"
#include "widgets/help/help_topic.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QLocale>
#include <QPainter>
#include <QPrinter>
#include <QPrintPreviewDialog>
#include <QTextDocument>

namespace codewheel {
namespace {

constexpr QSize previewSize(900, 700);
constexpr int printedPoints = 9; // font size in a table

void printReport(const Report &report, QPrinter &printer)
{
    const ReportPages pages(report);
    printer.setFullPage(true); // sheets include their margins
    QPainter painter(&printer);
    const double scale = static_cast<double>(printer.resolution()) / sheet::dotsPerInch;
    for (int page = 0; page < pages.count(); ++page) {
        if (page > 0)
            printer.newPage();
        painter.save();
        painter.scale(scale, scale);
        pages.paint(painter, page);
        painter.restore();
    }
}

void printTable(const QAbstractItemView &table, const QString &origin, QPrinter &printer)
{
    QTextDocument document;
    QFont font = QApplication::font();
    font.setPointSize(printedPoints);
    document.setDefaultFont(font);
    document.setHtml(printedTable(table, titleToPrint(table), origin));
    document.print(&printer);
}

} // namespace

Printing::Printing(QWidget &window, const ReportExport &report)
    : QObject(&window)
    , m_window(window)
    , m_report(report)
{}

void Printing::preview()
{
    m_table = tableToPrint(QApplication::focusWidget());
    QPrinter printer;
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setDocName(m_table ? titleToPrint(*m_table) : m_report.report().title);
    QPrintPreviewDialog dialog(&printer, &m_window);
    dialog.setObjectName(QStringLiteral("printPreview"));
    setHelpTopic(dialog, "report.md#print");
    dialog.resize(previewSize.boundedTo(m_window.size()));
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this,
            [this](QPrinter *target) { print(*target); });
    dialog.exec();
}

void Printing::print(QPrinter &printer) const
{
    if (m_table == nullptr) {
        printReport(m_report.report(), printer);
        return;
    }
    const QString origin =
        QStringLiteral("%1, %2").arg(m_window.windowTitle().remove(QStringLiteral("[*]")),
                                     QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat));
    printTable(*m_table, origin, printer);
}

} // namespace codewheel
