// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/report_pdf.h"

#include "pdf/paint_sheet.h"
#include "pdf/report_sheets.h"
#include "pdf/sheet_format.h"

#include <QFontDatabase>
#include <QGuiApplication>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace codewheel {
int writeReportPdf(const Report &report, QIODevice &device)
{
    const std::vector<Sheet> sheets = reportSheets(report);
    QPdfWriter writer(&device);
    writer.setTitle(report.subject.isEmpty() ? report.title
                                             : report.title + QStringLiteral(": ") + report.subject);
    writer.setCreator(report.origin);
    writer.setResolution(sheet::dotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({});

    QPainter painter;
    if (!painter.begin(&writer))
        return 0;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i > 0 && !writer.newPage())
            return 0;
        paintSheet(painter, sheets[i]);
    }
    return painter.end() ? static_cast<int>(sheets.size()) : 0;
}

bool hasFontsForPdf()
{
    return qobject_cast<QGuiApplication *>(QCoreApplication::instance()) != nullptr &&
           !QFontDatabase::families().isEmpty();
}

} // namespace codewheel
