// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/wizard_page.h"

class QLabel;

namespace codewheel {

class AccountView;

// The report, to be read, copied and saved as text or HTML.
class ReportPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit ReportPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    void showLatest() override;
    QString nextText() const override { return tr("&Close"); }

private:
    QLabel *m_leftIn;
    AccountView *m_report;
};

} // namespace codewheel
