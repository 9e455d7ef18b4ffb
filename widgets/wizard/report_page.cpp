// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/report_page.h"

#include "project/file_access.h"
#include "widgets/job/known_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/save_file.h"
#include "widgets/wizard/wizard_report.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace codewheel {

ReportPage::ReportPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Report"), parent)
    , m_leftIn(new QLabel(this))
    , m_text(new QPlainTextEdit(this))
    , m_save(new QPushButton(lineIcon(Icon::exportData), tr("S&ave the report..."), this))
    , m_message(new InlineMessage(this))
{
    m_leftIn->setWordWrap(true);
    m_leftIn->setObjectName(QStringLiteral("reportLeftIn"));
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(numberFont());
    m_text->setObjectName(QStringLiteral("report"));
    m_text->setAccessibleName(tr("Report"));
    describe(m_save, "saveReport", tr("As plain text, or as HTML if the name ends in .html."));

    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(grid::margin);
    layout->addWidget(m_leftIn);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_message);
    layout->addWidget(m_save, 0, Qt::AlignLeft);
    setFocusProxy(m_save);
    connect(m_save, &QPushButton::clicked, this, &ReportPage::saveAs);
}

void ReportPage::enter()
{
    const HandshakeRecord &record = m_setup.record;
    const std::optional<Outcome> &last = record.recovery ? record.recovery : record.outcome;
    m_message->withdraw();
    m_leftIn->setText(last ? leftInText(last->leftIn) : QString());
    m_text->setPlainText(
        reportAsText(record, m_setup.encoder->device(), QCoreApplication::applicationVersion()));
}

void ReportPage::saveAs()
{
    const QString name =
        QStringLiteral("encoder-%1-%2.txt")
            .arg(m_setup.record.place, m_setup.record.begun.toString(QStringLiteral("yyyy-MM-dd")));
    const QString path = askSaveFile(this, tr("Save the report"), name,
                                     tr("Text (*.txt);;Web page (*.html)").split(QStringLiteral(";;")));
    if (!path.isEmpty())
        saveTo(path);
}

bool ReportPage::saveTo(const QString &path)
{
    const bool asHtml = path.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive);
    const auto make = asHtml ? reportAsHtml : reportAsText;
    const QByteArray text =
        make(m_setup.record, m_setup.encoder->device(), QCoreApplication::applicationVersion()).toUtf8();
    const auto saved = replaceFile(path, text, OldFile::goes);
    if (saved)
        m_message->showMessage(Role::running, tr("The report was saved as %1.").arg(path));
    else
        m_message->showMessage(Role::fault, tr("The report was not saved as %1: %2. Choose another place.")
                                                .arg(path, whyNotWritten(saved.error())));
    return saved.has_value();
}

} // namespace codewheel
