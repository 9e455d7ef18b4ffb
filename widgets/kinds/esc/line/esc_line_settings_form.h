// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_limits.h"
#include "widgets/connect/link_form.h"
#include "widgets/input/number_fields.h"

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace codewheel {

class InlineMessage;
class PortField;

// The link of a serial line at a port: the port from a list or by its path, the format of the bytes, and the
// times the manual leaves open. Its plan is a EscLinePlan without an adapter.
class EscLineSettingsForm : public LinkForm
{
    Q_OBJECT

public:
    explicit EscLineSettingsForm(QWidget *parent = nullptr);

    QString title() const override { return tr("Serial port"); }
    QString sentence() const override;
    bool canBeTested() const override { return true; }
    bool showPlan(const KindData &plan) override;
    KindData plan() const override;
    QString wrong() const override;
    QString complaint() const override;

    EscLineSettings settings() const;
    void setSettings(const EscLineSettings &settings);
    // The port at which the line is open: shown as if never picked.
    void setPort(const QString &port);
    // The port was chosen in the list or typed, so whatever is there is meant.
    bool isPicked() const;
    // An encoder answers at a baud rate other than the line's; if there is no rate to change to, only the
    // sentence is shown. Empty: settled.
    void tellBaudRate(const QString &sentence, std::optional<int> wanted = {});
    // Whether an encoder could report the format of its scaling factor, and what was reported.
    void setCanDetermine(bool can);
    void setFractionBits(int bits);

Q_SIGNALS:
    void fractionBitsWanted();         // to be determined from an encoder
    void baudRateWanted(int baudRate); // as given to tellBaudRate(); set in the form

private:
    void addFields() override;
    void showPorts(const std::vector<PortRow> &ports, const Trouble &trouble) override;
    void makePort(QFormLayout &form);
    void makeCharacter(QFormLayout &form);
    void makeTimes(QFormLayout &form);
    void makeEncoder(QFormLayout &form);
    void makeFractionBits(QFormLayout &form);
    IntegerField *addNumber(QFormLayout &form, const QString &label, const QString &toolTip,
                            line_limits::Limits limits);
    QComboBox *addChoice(QFormLayout &form, const QString &label, const QString &toolTip);
    void readFields(EscLineSettings &settings) const;
    void showSettings(const EscLineSettings &settings);
    void takeRate();

    EscLineSettings m_given; // what the fields show of them may have been edited since
    bool m_canDetermine = false;
    PortField *m_port = nullptr;
    QComboBox *m_baudRate = nullptr;
    InlineMessage *m_rateTold = nullptr;
    std::optional<int> m_rateWanted;
    QComboBox *m_dataBits = nullptr;
    QComboBox *m_parity = nullptr;
    QComboBox *m_stopBits = nullptr;
    IntegerField *m_pollInterval = nullptr;
    IntegerField *m_timeOut = nullptr;
    IntegerField *m_retries = nullptr;
    IntegerField *m_quiet = nullptr;
    QCheckBox *m_lowLatency = nullptr;
    IntegerField *m_fractionBits = nullptr;
    QPushButton *m_determine = nullptr;
    DecimalField *m_topSpeed = nullptr;
};

} // namespace codewheel
