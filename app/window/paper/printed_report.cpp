// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/printed_report.h"

#include "app/report/report_pages.h"
#include "app/report/sheet_format.h"

#include <QPainter>
#include <QPrinter>

namespace codewheel {

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

} // namespace codewheel
