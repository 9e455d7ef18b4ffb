// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/wizard_page.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace codewheel {

class InlineMessage;

// The report, to be read, copied and saved as text or HTML.
class ReportPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit ReportPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    QString nextText() const override { return tr("&Close"); }

    // HTML where the name ends so, else text. False: it could not be written, and the page says why.
    bool saveTo(const QString &path);

private:
    void saveAs();

    QLabel *m_leftIn;
    QPlainTextEdit *m_text;
    QPushButton *m_save;
    InlineMessage *m_message;
};

} // namespace codewheel
