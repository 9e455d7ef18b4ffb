// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>

class QAction;
class QWidget;

namespace codewheel {

// The key of ALARM STOP: takes both hands, or one hand on purpose, with no other key nearby.
QKeySequence alarmStopKey();

// The look of its button: filled with red, or only a red rim where another button is the main one.
enum class AlarmStopWeight : std::uint8_t { filled, rim };

// Its button: red, with icon and text.
QWidget *makeAlarmStopButton(QAction *alarmStop, QWidget *parent,
                             AlarmStopWeight weight = AlarmStopWeight::filled);

// Keeps ALARM STOP within reach whatever has the focus: its key works while a question is open, and each
// modal dialog gets a button of its own, since the tool bar behind it cannot be clicked.
class AlarmStopEverywhere : public QObject
{
    Q_OBJECT

public:
    explicit AlarmStopEverywhere(QAction &alarmStop, QObject *parent = nullptr);
    ~AlarmStopEverywhere() override;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addButton(QWidget &dialog);

    QAction &m_alarmStop;
};

} // namespace codewheel
