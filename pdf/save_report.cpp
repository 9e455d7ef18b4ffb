// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/save_report.h"

#include "pdf/report_pdf.h"
#include "project/file_access.h"
#include "report/html_report.h"

#include <QBuffer>
#include <QCoreApplication>

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
    if (!hasFontsForPdf())
        return notWritten(path, SavedReport::tr("no font is installed"));
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    const int sheets = writeReportPdf(report, pdf);
    if (sheets == 0)
        return notWritten(path, SavedReport::tr("the sheets could not be painted"));
    return replaceFile(path, pdf.data(), OldFile::goes).map([&] { return sheets; });
}

} // namespace codewheel
