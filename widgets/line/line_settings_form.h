// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_limits.h"
#include "widgets/look/page.h"

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;
class QSpinBox;

namespace codewheel {

class InlineMessage;
class PortField;
struct PortRow;

// How a serial line is to be opened: the port from a list or by its path, the format of the bytes, and the
// times the manual leaves open. Does not find ports itself: the list is given.
class LineSettingsForm : public Page
{
    Q_OBJECT

public:
    explicit LineSettingsForm(QWidget *parent = nullptr);

    void setAbout(const QString &line); // the name of the line
    QString title() const override { return tr("Port and settings"); }
    QString about() const override { return m_about; }
    QString effect() const override;

    // `trouble`: a sentence shown with the list, such as about missing rights; empty: none. The choice stays,
    // even if it is not in the list.
    void setPorts(const std::vector<PortRow> &ports, const QString &trouble = {});
    LineSettings settings() const;
    void setSettings(const LineSettings &settings);
    // The port at which the line is open: shown as if never picked.
    void setPort(const QString &port);
    void setConnecting(bool on); // for as long as the port takes to open
    void setCanKeep(bool can);   // not while the line is open: the project then has its port
    // What went wrong when it was opened; empty: nothing.
    void setProblem(const QString &sentence);
    // The adapter present is not that of the line; ends with otherAdapterWanted() if it is meant.
    void askForOtherAdapter(const QString &sentence);
    // An encoder answers at a baud rate other than the line's; if there is no rate to change to, only the
    // sentence is shown. Empty: settled.
    void tellBaudRate(const QString &sentence, std::optional<int> wanted = {});
    // Whether an encoder could report the format of its scaling factor, and what was reported.
    void setCanDetermine(bool can);
    void setFractionBits(int bits);

Q_SIGNALS:
    void refreshWanted();
    void fractionBitsWanted(); // to be determined from an encoder
    // isPicked: the port was chosen in the list or typed, so whatever is there is meant.
    void connectWanted(const codewheel::LineSettings &settings, bool isPicked);
    void keepWanted(const codewheel::LineSettings &settings, bool isPicked); // without opening it
    void otherAdapterWanted(const codewheel::LineSettings &settings);
    void baudRateWanted(int baudRate); // as given to tellBaudRate(); set in the form

private:
    void makePort(QFormLayout &form);
    void makeCharacter(QFormLayout &form);
    void makeTimes(QFormLayout &form);
    void makeEncoder(QFormLayout &form);
    void makeFractionBits(QFormLayout &form);
    QSpinBox *addNumber(QFormLayout &form, const QString &label, const QString &toolTip,
                        line_limits::Limits limits);
    QComboBox *addChoice(QFormLayout &form, const QString &label, const QString &toolTip);
    bool takeTyped();
    bool isComplete(const LineSettings &settings);
    bool hasRate(const LineSettings &settings);
    void connectNow();
    void keep();
    void connectOther();
    void takeRate();

    QString m_about;
    QWidget *m_content;
    PortField *m_port;
    QComboBox *m_baudRate = nullptr;
    InlineMessage *m_rateTold;
    std::optional<int> m_rateWanted;
    QComboBox *m_dataBits = nullptr;
    QComboBox *m_parity = nullptr;
    QComboBox *m_stopBits = nullptr;
    QSpinBox *m_pollInterval = nullptr;
    QSpinBox *m_timeOut = nullptr;
    QSpinBox *m_retries = nullptr;
    QSpinBox *m_quiet = nullptr;
    QCheckBox *m_lowLatency = nullptr;
    QSpinBox *m_fractionBits = nullptr;
    QPushButton *m_determine = nullptr;
    QDoubleSpinBox *m_topSpeed = nullptr;
    InlineMessage *m_problem;
    QPushButton *m_keep;
    QPushButton *m_connect;
    esc::Timing m_timing; // includes what the form does not show
};

} // namespace codewheel
