// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/wizard_page.h"

class QLabel;
class QListWidget;

namespace codewheel {

class InlineMessage;

// Which encoder to set up: those of the bus that can be written.
class DevicePage final : public WizardPage
{
    Q_OBJECT

public:
    explicit DevicePage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override;

Q_SIGNALS:
    void encoderChosen(codewheel::EncoderSession *encoder);

private:
    void takeSelected();
    void describeChosen();

    QListWidget *m_list;
    QLabel *m_description;
    InlineMessage *m_problem;
    std::vector<EncoderSession *> m_encoders; // by row
};

} // namespace codewheel
