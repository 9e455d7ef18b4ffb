// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include <functional>

class QMessageBox;
class QWidget;

namespace codewheel {

class BusAtWork;
class EncoderBus;

// What the question says of a bus of one kind.
struct OperateWarning
{
    QString question; // with the name of the bus, where there are several
    QString explanation;
    const char *helpTopic = "";
};

// Before a real bus goes to Operate for the first time since it was connected: what that means, and what can
// move there. Nothing is asked of a simulated bus, nor again before it is disconnected or is a different
// one.
class OperateQuestion : public QObject
{
    Q_OBJECT

public:
    using Warning = std::function<OperateWarning(const EncoderBus &bus)>;

    // The bus outlives it. `window`: the question stands in front of it.
    OperateQuestion(BusAtWork &atWork, Warning warning, QWidget &window, QObject *parent);

    // Calls `then` at once, or when the user agrees; not at all if the bus stays in Watch. If the question
    // is open already, the newer `then` counts.
    void ask(std::function<void()> then);

private:
    void followSession();
    void followBus();
    void beginAnew();
    void open(const EncoderBus &bus);
    void withdraw();

    BusAtWork &m_atWork;
    const Warning m_warning;
    QWidget &m_window;
    bool m_isAnswered = false; // for this connection
    std::function<void()> m_then;
    QPointer<QMessageBox> m_box;
};

} // namespace codewheel
