// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/number_fields.h"
#include "widgets/training/left_alone.h"

#include <QWidget>

#include <cstdint>
#include <optional>

class QGridLayout;
class QLabel;

namespace codewheel {

class HandWheel;

// The shaft of a simulated encoder: turned by hand, to a raw position, or at a speed. What moves it is up to
// the training panel that it is part of.
class ShaftFields : public QWidget
{
    Q_OBJECT

public:
    struct Shaft
    {
        std::int64_t raw = 0; // steps
        int stepsPerTurn = 0;
        int turns = 0;
        double revolutionsPerMinute = 0;
    };

    explicit ShaftFields(double fastest, QWidget *parent = nullptr); // rpm

    // With each frame. A field changes only when the shaft has changed, so as not to undo what the user has
    // just typed before the bus has taken it.
    void showShaft(const Shaft &shaft);
    // The panel turns to another device, or to another bus.
    void leave();

Q_SIGNALS:
    void turned(qint64 steps); // by hand; clockwise positive
    void turnedTo(int raw);
    void speedSet(double rpm);
    void leftAlone(qint64 raw); // after it was turned by hand

private:
    void makePosition(QGridLayout *grid);
    void makeSpeed(QGridLayout *grid, double fastest);
    void turnBy(qint64 steps);
    void turnTo();
    void tellOfTurning();

    std::optional<Shaft> m_shown;
    LeftAlone m_leftAlone;
    HandWheel *m_wheel;
    QLabel *m_raw;
    QLabel *m_turn;
    IntegerField *m_target;
    DecimalField *m_speed;
};

} // namespace codewheel
