// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/label_key.h"
#include "widgets/transfer/replace_step.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace codewheel {

class InlineMessage;

// The encoder that was there: as planned, or, where no project has it, as it is on the bus. Null: not known.
const DeviceDescription *deviceBefore(const Replacing &replacing);

// Which encoder is there now: by the key on its label or a choice from the catalog, with its serial number;
// and how it differs from the previous one.
class ReplaceDeviceStep final : public ReplaceStep
{
    Q_OBJECT

public:
    explicit ReplaceDeviceStep(Replacing &replacing, QWidget *parent = nullptr);
    ~ReplaceDeviceStep() override;

    void enter() override;
    bool leave() override;
    bool mayGoOn() const override { return m_replacing.now.device != nullptr; }

private:
    Result<void> canBe(const DeviceDescription &device) const; // at this place
    QString exampleOfKey() const;
    void fillChoices();
    void readKey(const QString &typed);
    void tellProblem();
    void take();
    void showDifferences();

    std::vector<LabelMatch> m_matches;
    std::optional<Refusal> m_problem; // of the typed key
    QLabel *m_planned;
    QLineEdit *m_key;
    QComboBox *m_choice;
    QLineEdit *m_serial;
    QLabel *m_differences;
    InlineMessage *m_message;
};

} // namespace codewheel
