// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>

class QAction;
class QWidget;

namespace codewheel {

// The key of ALARM STOP: both hands, or one hand with intent, and nothing else nearby.
QKeySequence alarmStopKey();

// Of its button: filled with red, or only a red rim where another button is what one came for.
enum class AlarmStopWeight : std::uint8_t { filled, rim };

// A button for it: red, icon and words.
QWidget *makeAlarmStopButton(QAction *alarmStop, QWidget *parent,
                             AlarmStopWeight weight = AlarmStopWeight::filled);

// Keeps ALARM STOP in reach of every focus: its key works while a question is on the screen, and each modal
// dialog gets a button of its own, since the tool bar behind it cannot be clicked.
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
