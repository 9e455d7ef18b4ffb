// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/project_places.h"
#include "transfer/transfer_account.h"
#include "widgets/transfer/replace_step.h"
#include "widgets/transfer/transfer_model.h"

class QLabel;

namespace codewheel {

class AccountView;
class EepromGate;
class InlineMessage;
class JobStrip;
class TransferTable;

// What will be written to the new encoder, with the words; then the writing.
class ReplaceWriteStep final : public ReplaceStep
{
    Q_OBJECT

public:
    explicit ReplaceWriteStep(Replacing &replacing, QWidget *parent = nullptr);

    void enter() override;
    void refresh() override { showPlan(); }
    bool leave() override;
    bool mayGoOn() const override;
    bool mayGoBack() const override { return !m_round.isRunning(); }
    QString nextText() const override { return tr("&Write"); }

    bool isBusy() const override { return m_round.isRunning(); }
    // From now on nothing that was known of the previous encoder is known of the one that is there, and what
    // is counted is its.
    void takeNew();
    void begin();
    // Of the writing, once it has ended.
    TransferAccount account() const;

Q_SIGNALS:
    void ended();

private:
    void showPlan();
    static QString noteOf(const EncoderPlan &plan);
    void followEncoder();
    ProjectPlaces places() const;

    JobRound m_round;
    TransferPlan m_plan;
    EncoderState m_plannedIn = EncoderState::notSeen; // what the encoder showed then
    bool m_isFixed = false;                           // what is shown is being written
    QString m_source; // for the account: another project may be open when the writing ends
    TransferModel *m_model;
    TransferTable *m_table;
    QLabel *m_note;
    InlineMessage *m_message;
    EepromGate *m_gate;
    JobStrip *m_progress;
};

// What was written, to be saved.
class ReplaceAccountStep final : public ReplaceStep
{
    Q_OBJECT

public:
    explicit ReplaceAccountStep(Replacing &replacing, QWidget *parent = nullptr);

    void show(const TransferAccount &account);
    bool mayGoBack() const override { return false; }
    QString nextText() const override { return tr("&Close"); }

private:
    QLabel *m_result;
    AccountView *m_account;
};

} // namespace codewheel
