// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/save_report.h"

#include "app/report/report_pages.h"
#include "app/report/sheet_format.h"
#include "project/file_access.h"
#include "report/html_report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace codewheel {
namespace {

// The context of these texts.
struct SavedReport
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::SavedReport)
};

tl::unexpected<Refusal> notWritten(const QString &path, const QString &reason)
{
    return refuse(RefusalKind::badInput, RefusalId::fileNotWritten, {path, reason});
}

bool hasFonts()
{
    return qobject_cast<QGuiApplication *>(QCoreApplication::instance()) != nullptr &&
           !QFontDatabase::families().isEmpty();
}

// Returns the number of sheets; 0 if they could not be painted.
int writePdf(const Report &report, QIODevice &device)
{
    const ReportPages pages(report);
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
    for (int page = 0; page < pages.count(); ++page) {
        if (page > 0 && !writer.newPage())
            return 0;
        pages.paint(painter, page);
    }
    return painter.end() ? pages.count() : 0;
}

} // namespace

std::optional<ReportFormat> reportFormat(const QString &path)
{
    if (path.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive))
        return ReportFormat::html;
    if (path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive))
        return ReportFormat::pdf;
    return std::nullopt;
}

Result<int> saveReport(const Report &report, const QString &path, ReportFormat format)
{
    if (format == ReportFormat::html)
        return replaceFile(path, reportAsHtml(report), OldFile::goes).map([] { return 0; });
    if (const auto can = checkReplaceable(path); !can)
        return tl::unexpected(can.error());
    if (!hasFonts())
        return notWritten(path, SavedReport::tr("no font is installed"));
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    const int sheets = writePdf(report, pdf);
    if (sheets == 0)
        return notWritten(path, SavedReport::tr("the pages could not be painted"));
    return replaceFile(path, pdf.data(), OldFile::goes).map([&] { return sheets; });
}

} // namespace codewheel
