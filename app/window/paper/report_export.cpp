// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/report_export.h"

#include "app/report/save_report.h"
#include "app/window/paper/report_preview.h"
#include "report/kept_counts.h"
#include "report/live_encoders.h"
#include "report/make_report.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/save_file.h"
#include "widgets/project/project_document.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

namespace codewheel {

ReportExport::ReportExport(QWidget &window, const ProjectDocument &document, const Buses &buses,
                           const Catalog &catalog, FindLedgers ledgers, InlineMessage &notice)
    : QObject(&window)
    , m_window(window)
    , m_document(document)
    , m_buses(buses)
    , m_catalog(catalog)
    , m_ledgers(std::move(ledgers))
    , m_notice(notice)
{
    connect(&notice, &InlineMessage::actionTriggered, this, [this] {
        if (m_notice.sentence() == m_told) // the window's notice may be about something else by now
            openSaved();
    });
}

void ReportExport::openSaved()
{
    if (QDesktopServices::openUrl(QUrl::fromLocalFile(m_saved)))
        m_notice.withdraw();
    else
        m_notice.showMessage(Role::attention,
                             tr("No program on this computer opens %1. The report is saved.").arg(m_saved));
}

QString ReportExport::proposedPath() const
{
    const QFileInfo project(m_document.file());
    const QString name = m_document.file().isEmpty() ? tr("report", "file name") : project.completeBaseName();
    return project.dir().filePath(name + QStringLiteral(".pdf"));
}

void ReportExport::preview()
{
    ReportPreview dialog(report(), &m_window);
    if (dialog.exec() == QDialog::Accepted)
        askWhere();
}

void ReportExport::askWhere()
{
    const QString path = askSaveFile(&m_window, tr("Save the commissioning report"), proposedPath(),
                                     {tr("PDF (*.pdf)"), tr("Web page (*.html)")}, "report.md");
    if (!path.isEmpty())
        saveTo(path);
}

Report ReportExport::report() const
{
    ReportInput input{.project = m_document.project(),
                      .file = QFileInfo(m_document.file()).fileName(),
                      .version = QCoreApplication::applicationVersion(),
                      .now = QDateTime::currentDateTime()};
    addConnected(input, m_buses);
    for (const LedgerKeeper *keeper : m_ledgers())
        if (keeper->ledger() != nullptr)
            addKept(input, *keeper->ledger(), m_catalog, m_document.file());
    return makeReport(input, m_catalog);
}

bool ReportExport::saveTo(const QString &path)
{
    const auto format = reportFormat(path);
    if (!format) {
        m_notice.showMessage(Role::fault,
                             tr("The report was not saved: %1 ends neither in .pdf nor in .html.").arg(path));
        return false;
    }
    const auto saved = saveReport(report(), path, *format);
    if (!saved) {
        m_notice.showMessage(Role::fault, refusalText(saved.error()));
        return false;
    }
    const Message message{
        .severity = Severity::information, .id = MessageId::reportSaved, .arguments = {path}};
    m_saved = path;
    m_told = messageText(message);
    m_notice.showMessage(Role::running, m_told, tr("&Open"));
    Q_EMIT told(message);
    return true;
}

} // namespace codewheel
