// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QObject>
#include <QPointer>

#include <functional>

class QMessageBox;
class QWidget;

namespace codewheel {

class EncoderBus;

// Before a real ring goes to Operate for the first time since it was connected: what that means, and what can
// move there. Nothing is asked of a simulated ring, nor again before it is disconnected or is a different
// one.
class OperateQuestion : public QObject
{
    Q_OBJECT

public:
    using Called =
        std::function<QString(Place device, const QString &name)>; // by the name of its description

    // The ring outlives it. `window`: the question stands in front of it.
    OperateQuestion(EncoderBus &ring, Called called, QWidget &window, QObject *parent);

    // Calls `then` at once, or when the user agrees; not at all if the ring stays in Watch. If the question
    // is open already, the newer `then` counts.
    void ask(std::function<void()> then);

private:
    void open();
    void followRing();
    QString explanation() const;
    QStringList movable() const; // devices with OUT that are not known as encoders
    QStringList outNotKnown() const;

    EncoderBus &m_ring;
    const Called m_called;
    QWidget &m_window;
    bool m_isAnswered = false; // for this connection
    std::function<void()> m_then;
    QPointer<QMessageBox> m_box;
};

} // namespace codewheel
