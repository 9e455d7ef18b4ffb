// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/review_table.h"
#include "widgets/job/step_table.h"
#include "widgets/wizard/wizard_page.h"

class QCheckBox;
class QLabel;
class QRadioButton;
class QTableView;

namespace codewheel {

class EepromGate;
class InlineMessage;
class NowAndThen;
struct WritePlan;

// What is about to be sent: old and new values, the exact words, EEPROM writes.
class ReviewPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit ReviewPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override;
    QString nextText() const override { return tr("&Start the handshake"); }
    void showKnown() override { plan(); }

private:
    void plan();
    QString nothingToWrite() const;
    void showPicture();
    QStringList notes(const WritePlan &plan) const;
    QString verificationNote() const;

    ReviewTable m_changes;
    StepTable m_steps{StepTable::Stage::planned};
    QTableView *m_changesView;
    NowAndThen *m_picture;
    QLabel *m_words; // describes the steps
    QTableView *m_stepsView;
    QCheckBox *m_writeAll;
    QLabel *m_writes;
    EepromGate *m_gate;
    QLabel *m_note;
    QRadioButton *m_byHand;
    QRadioButton *m_byItself;
    InlineMessage *m_problem;
    bool m_mayGoOn = false;
};

} // namespace codewheel
