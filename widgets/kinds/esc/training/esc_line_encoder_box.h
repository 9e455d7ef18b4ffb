// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "widgets/input/number_fields.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QLabel;

namespace codewheel {

class HandWheel;

// A simulated encoder of the serial line: its shaft, and what can happen to it. Part of the training panel.
class EscEncoderBox : public QWidget
{
    Q_OBJECT

public:
    explicit EscEncoderBox(QWidget *parent = nullptr);

    // With each frame; the line outlives it, or another one is shown first. An address that no longer has an
    // encoder keeps showing the last one.
    void showEncoder(SimulatedEscLine &line, EscLineAddress address);

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    struct Trouble
    {
        bool EscCondition::*flag;
        LineTrouble name;
        QString toolTip;
        QCheckBox *box = nullptr;
    };

    void showShaft(const TurningShaft &shaft);
    void turnBy(qint64 steps);
    void setSpeed(double rpm);
    void set(const Trouble &trouble, bool ticked);

    SimulatedEscLine *m_line = nullptr;
    EscLineAddress m_address;
    HandWheel *m_wheel;
    QLabel *m_raw;
    DecimalField *m_speed;
    std::array<Trouble, 9> m_troubles;
};

} // namespace codewheel
