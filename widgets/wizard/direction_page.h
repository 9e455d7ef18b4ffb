// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/turn_check.h"
#include "widgets/wizard/wizard_page.h"

class QLabel;
class QPushButton;
class QRadioButton;

namespace codewheel {

class AgeTimer;
class InlineMessage;
class RoleLabel;

// The user moves shaft or magnet in the direction that is to count up; the page shows what the encoder does,
// and reverses the wanted direction if the user says so. Sends nothing.
class DirectionPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit DirectionPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    void showLatest() override;

private:
    void begin();
    void showNow();
    void showOld();
    void showVerdict();
    void choose();

    TurnCheck m_check;
    bool m_usesRawWord = false;
    bool m_wasOld = false;
    AgeTimer *m_age;
    QLabel *m_what;
    QLabel *m_position;
    RoleLabel *m_verdict;
    QLabel *m_moved;
    QPushButton *m_again;
    QRadioButton *m_asNow;
    QRadioButton *m_otherWay;
    InlineMessage *m_problem;
};

// The same direction or coding reversed; nothing if the device has none.
std::optional<ParameterValue> otherDirection(const EncoderSession &encoder);

} // namespace codewheel
