// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/save_report.h"

#include "pdf/report_pdf.h"
#include "report/html_report.h"

#include <QCoreApplication>
#include <QSaveFile>

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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return notWritten(path, file.errorString());
    int sheets = 0;
    if (format == ReportFormat::html) {
        const QByteArray html = reportAsHtml(report);
        if (file.write(html) != html.size())
            return notWritten(path, file.errorString());
    } else {
        if (!hasFontsForPdf())
            return notWritten(path, SavedReport::tr("no font is installed"));
        sheets = writeReportPdf(report, file);
        if (sheets == 0)
            return notWritten(path, file.errorString());
    }
    if (!file.commit())
        return notWritten(path, file.errorString());
    return sheets;
}

} // namespace codewheel
