// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/setup/node_check.h"
#include "kinds/canopen/setup/node_task_run.h"
#include "widgets/transfer/replace_step.h"

#include <memory>

class QLabel;
class QPushButton;
class QRadioButton;

namespace codewheel {

class CanopenSession;
class NodeNumberField;
class NodeSetupView;
struct Outcome;

// The encoder that replaces another on a CAN bus takes its place there: as it comes it has another number,
// most 127 or 1, or none.
class CanReplaceNumberStep final : public ReplaceStep
{
    Q_OBJECT

public:
    explicit CanReplaceNumberStep(Replacing &replacing, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override;
    bool mayGoBack() const override { return !isBusy(); }
    bool isBusy() const override;
    QString effect() const override;
    QString doneSoFar() const override;

    NodeSetupView &view() const { return *m_view; }
    // Of the new encoder, once it was read.
    const std::optional<canopen::NodeIdentity> &identity() const;

Q_SIGNALS:
    void messaged(const codewheel::Message &message);

private:
    void chooseDevice();
    void takeSerial();

    QLabel *m_about;
    QRadioButton *m_isThere;  // it has the number already
    QRadioButton *m_hasOther; // it has that of the field
    QRadioButton *m_hasNone;
    NodeNumberField *m_number;
    NodeSetupView *m_view;
    bool m_hasGivenNumber = false;
};

// Once its supply was off and on, the new encoder has to be there with its number and all that was written.
class CanReplaceProofStep final : public ReplaceStep
{
    Q_OBJECT

public:
    // `number` is of the same replacement, and outlives it.
    CanReplaceProofStep(Replacing &replacing, const CanReplaceNumberStep &number, QWidget *parent = nullptr);
    ~CanReplaceProofStep() override;

    void enter() override;
    void refresh() override {}
    bool mayGoOn() const override { return !isBusy(); }
    bool mayGoBack() const override { return false; }
    bool isBusy() const override { return m_run.isRunning() || m_isReading; }
    QString effect() const override;

private:
    void check();
    void takeChecked();
    void readValues();
    void compare(const Outcome &outcome);
    void end(const QString &text);
    CanopenSession *bus() const;
    ParameterValues wanted() const; // that can be read back

    const CanReplaceNumberStep &m_number;
    NodeTaskRun m_run;
    std::unique_ptr<canopen::NodeCheck> m_check;
    canopen::BootUps m_bootUps{}; // heard before its supply was to be switched
    bool m_isReading = false;
    QLabel *m_result;
    QPushButton *m_checkNow;
};

} // namespace codewheel
