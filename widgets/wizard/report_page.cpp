// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/report_page.h"

#include "widgets/job/account_view.h"
#include "widgets/job/known_text.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/wizard/wizard_report.h"

#include <QCoreApplication>

namespace codewheel {

ReportPage::ReportPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Report"), parent)
    , m_leftIn(wrappedLabel(this, "reportLeftIn"))
    , m_report(new AccountView(this))
{
    layOutColumn(this, {m_leftIn, {m_report, 1}}, {.spacing = grid::margin});
    setFocusProxy(m_report);
}

void ReportPage::enter()
{
    const HandshakeRecord &record = m_setup.record;
    showLatest();
    m_report->show(reportOf(record, m_setup.encoder->device(), QCoreApplication::applicationVersion()),
                   QStringLiteral("encoder-%1-%2")
                       .arg(record.place, record.begun.toString(QStringLiteral("yyyy-MM-dd"))));
}

// The report says how it was at the end; the line above it follows the encoder.
void ReportPage::showLatest()
{
    m_leftIn->setText(m_setup.record.last() ? leftInText(m_setup.stateNow()) : QString());
}

} // namespace codewheel
