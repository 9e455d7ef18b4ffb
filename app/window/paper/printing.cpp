// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/printing.h"

#include "app/window/paper/picture_in_text.h"
#include "app/window/paper/printed_report.h"
#include "app/window/paper/printed_table.h"
#include "app/window/paper/report_export.h"
#include "widgets/help/help_topic.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QLocale>
#include <QPrinter>
#include <QPrintPreviewDialog>
#include <QTextCursor>
#include <QTextDocument>

namespace codewheel {
namespace {

constexpr QSize previewSize(900, 700);
constexpr int printedPoints = 9; // font size in a table

void printSheets(QTextDocument &document, QPrinter &printer)
{
    QFont font = QApplication::font();
    font.setPointSize(printedPoints);
    document.setDefaultFont(font);
    document.print(&printer);
}

void printTable(const QAbstractItemView &table, const QString &origin, QPrinter &printer)
{
    QTextDocument document;
    document.setHtml(printedHead(titleToPrint(table), origin) + printedTable(table));
    printSheets(document, printer);
}

void printView(const PrintedView &view, const Printing::Names &names, const QString &origin,
               QPrinter &printer)
{
    QStringList whose{view.place.shown(), names.station(view.place), view.device};
    whose.removeAll(QString());
    QTextDocument document;
    QString head = printedHead(view.title, origin);
    if (!view.place.isEmpty())
        head += printedValues({{Printing::tr("Encoder"), whose.join(QStringLiteral("  "))},
                               {Printing::tr("Bus"), names.bus(view.place.bus)}});
    document.setHtml(head);
    PictureInText pictures(view.pictures);
    pictures.insertInto(document);
    QTextCursor end(&document);
    end.movePosition(QTextCursor::End);
    end.insertHtml(printedValues(view.values));
    if (view.table) {
        end.insertBlock();
        end.insertHtml(printedTable(*view.table));
    }
    printSheets(document, printer);
}

} // namespace

Printing::Printing(QWidget &window, const ReportExport &report, Names names)
    : QObject(&window)
    , m_window(window)
    , m_report(report)
    , m_names(std::move(names))
{}

void Printing::preview()
{
    const QWidget *focus = QApplication::focusWidget();
    m_view = viewToPrint(focus);
    m_table = m_view ? nullptr : tableToPrint(focus);
    m_when = QDateTime::currentDateTime();
    QPrinter printer;
    printer.setPageSize(QPageSize(QPageSize::A4));
    printer.setDocName(title());
    QPrintPreviewDialog dialog(&printer, &m_window);
    dialog.setObjectName(QStringLiteral("printPreview"));
    setHelpTopic(dialog, "report.md#print");
    dialog.resize(previewSize.boundedTo(m_window.size()));
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this,
            [this](QPrinter *target) { print(*target); });
    dialog.exec();
}

QString Printing::title() const
{
    if (m_view)
        return QStringLiteral("%1 %2").arg(m_view->title, m_view->place.shown()).trimmed();
    return m_table ? titleToPrint(*m_table) : m_report.report().title;
}

QString Printing::origin() const
{
    return QStringLiteral("%1, %2").arg(m_window.windowTitle().remove(QStringLiteral("[*]")),
                                        QLocale().toString(m_when, QLocale::ShortFormat));
}

void Printing::print(QPrinter &printer) const
{
    if (m_view)
        printView(*m_view, m_names, origin(), printer);
    else if (m_table)
        printTable(*m_table, origin(), printer);
    else
        printReport(m_report.report(), printer);
}

} // namespace codewheel
