// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc_line/line_limits.h"
#include "widgets/line/port_row.h"
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

// How a serial line is to be opened: the port by list or by its path, what the bytes look like, and the times
// that the manual leaves open. Knows no ports by itself: the list is given.
class LineSettingsForm : public Page
{
    Q_OBJECT

public:
    explicit LineSettingsForm(QWidget *parent = nullptr);

    void setAbout(const QString &line); // the name of the line
    QString title() const override { return tr("Port and settings"); }
    QString about() const override { return m_about; }
    QString effect() const override;

    // `trouble`: a sentence that stands at the list, such as missing rights; empty: none. What is chosen
    // stays chosen, also where it is not in the list.
    void setPorts(const std::vector<PortRow> &ports, const QString &trouble = {});
    LineSettings settings() const;
    void setSettings(const LineSettings &settings);
    // Where the line is open: it stands there as if it was never picked.
    void setPort(const QString &port);
    void setConnecting(bool on); // it takes as long as the port takes to open
    void setCanKeep(bool can);   // not while the line is open: the project has the port that is
    // What went wrong when it was opened; empty: nothing.
    void setProblem(const QString &sentence);
    // Another adapter than that of the line is there; ends with otherAdapterWanted() where it is meant.
    void askForOtherAdapter(const QString &sentence);
    // An encoder speaks at another baud rate than the line; without a rate that the line should have, nothing
    // but the sentence. Empty: it is settled.
    void tellBaudRate(const QString &sentence, std::optional<int> wanted = {});
    // Whether there is an encoder that could tell the format of its scaling factor, and what it told.
    void setCanDetermine(bool can);
    void setFractionBits(int bits);

Q_SIGNALS:
    void refreshWanted();
    void fractionBitsWanted(); // to be determined from an encoder
    // isPicked: the port was chosen in the list or typed anew, so whatever is there is meant.
    void connectWanted(const codewheel::LineSettings &settings, bool isPicked);
    void keepWanted(const codewheel::LineSettings &settings, bool isPicked); // without being opened
    void otherAdapterWanted(const codewheel::LineSettings &settings);
    void baudRateWanted(int baudRate); // that tellBaudRate() named; it stands in the form

private:
    void makePort(QFormLayout &form);
    void makeCharacter(QFormLayout &form);
    void makeTimes(QFormLayout &form);
    void makeEncoder(QFormLayout &form);
    void makeFractionBits(QFormLayout &form);
    QSpinBox *addNumber(QFormLayout &form, const QString &label, const QString &toolTip,
                        line_limits::Limits limits);
    QComboBox *addChoice(QFormLayout &form, const QString &label, const QString &toolTip);
    QString chosenPort() const;
    bool takeTyped();
    bool isComplete(const LineSettings &settings);
    bool hasRate(const LineSettings &settings);
    void connectNow();
    void keep();
    void connectOther();
    void takeRate();
    void pick() { m_isPicked = true; }
    void showPorts();

    QString m_about;
    std::vector<PortRow> m_ports;
    QWidget *m_content;
    QComboBox *m_port = nullptr;
    bool m_isPicked = false; // the port, since it was set
    QPushButton *m_refresh = nullptr;
    InlineMessage *m_trouble;
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
    esc::Timing m_timing; // with what the form does not show
};

} // namespace codewheel
