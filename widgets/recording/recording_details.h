// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/recording/shown_recording.h"

#include <QDialog>

#include <map>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace codewheel {

class InlineMessage;

// More about the recording that runs, or waits: how it gets on, and what can be done with it. Not modal: it
// stands beside the work.
class RecordingDetails : public QDialog
{
    Q_OBJECT

public:
    explicit RecordingDetails(QWidget *parent);

    void showRecording(const ShownRecording &recording);
    void tellThatItRuns(); // where another one was to be begun

Q_SIGNALS:
    void fireWanted();
    void noteWanted(const QString &text);
    void endWanted();

private:
    enum class Row : std::uint8_t { state, encoders, since, size, free, full, lost };

    void addRow(QFormLayout &form, Row row, const char *id, const QString &title);
    void makeButtons();
    void showRow(Row row, const QString &text);
    void showProblem(const std::optional<Refusal> &problem);
    void takeNote();

    QLineEdit *m_file;
    std::map<Row, QLabel *> m_values;
    InlineMessage *m_message;
    QLineEdit *m_note;
    QPushButton *m_add;
    QPushButton *m_fire = nullptr;
    bool m_tellsProblem = false;
};

} // namespace codewheel
