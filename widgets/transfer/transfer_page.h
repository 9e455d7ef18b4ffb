// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "widgets/look/page.h"
#include "widgets/transfer/transfer_choice.h"
#include "widgets/transfer/transfer_model.h"

#include <QTimer>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace codewheel {

class AccountView;
class Catalog;
class EepromGate;
class InlineMessage;
class JobStrip;
class ProjectDocument;
class TransferTable;

// Values to and from several encoders: what to transfer, which encoders, what differs with its words and
// EEPROM writes; then the writing, with progress and cancel; then what was written where. A page of the main
// window, for engineers commissioning a bus, and technicians restoring one.
class TransferPage : public Page
{
    Q_OBJECT

public:
    // All must outlive it.
    TransferPage(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                 FindValuesBefore findBefore, QWidget *parent = nullptr);

    // Shows what differs now. `number`: the encoder chosen elsewhere.
    void choose(TransferChoice::What what, std::optional<Place> number);
    bool isBusy() const { return m_round.isRunning(); }
    QString title() const override { return tr("Transfer"); }
    QString effect() const override;
    QString lostByClosing() const override { return isBusy() ? goesOn() : QString(); }

Q_SIGNALS:
    void messaged(const codewheel::Message &message);

private:
    void layOut();
    void connectAll();
    void followEncoders();
    void showPlan();
    void planSoon();
    void showSummary();
    void begin();
    bool mayBeRead() const;
    void carryOut();
    void finish();
    void finishStoring();
    void finishWriting();
    void backToChoice();
    TransferPlan chosenPlan() const;
    std::vector<EncoderJobs> jobsToDo() const;
    TransferPlan planOfCost() const;
    void showBegin();
    QString source() const;

    const Buses &m_buses;
    const Catalog &m_catalog;
    ProjectDocument &m_project;
    JobRound m_round;
    TransferPlan m_plan;
    std::vector<Place> m_toStore;
    QTimer m_soon; // many encoders change together
    TransferChoice *m_choice;
    TransferModel *m_model;
    TransferTable *m_table;
    QPushButton *m_all;
    QPushButton *m_none;
    QCheckBox *m_stop;
    QLabel *m_summary;
    InlineMessage *m_problem;
    EepromGate *m_gate;
    QPushButton *m_begin;
    JobStrip *m_progress;
    QStackedWidget *m_stage;
    QWidget *m_choosing;
    QWidget *m_done;
    QLabel *m_result;
    AccountView *m_account;
    QPushButton *m_back;
};

} // namespace codewheel
