// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"
#include "widgets/input/number_fields.h"
#include "widgets/kinds/interbus/training/left_alone.h"
#include "widgets/kinds/interbus/training/shared_controls.h"

#include <QWidget>

#include <optional>

class QGridLayout;
class QLabel;

namespace codewheel {

class HandWheel;

// The shaft of a simulated encoder: turned by hand, to a raw position, or at a speed. Part of the training
// panel.
class ShaftControls : public QWidget
{
    Q_OBJECT

public:
    explicit ShaftControls(const SharedControls &controls, QWidget *parent = nullptr);

    // With each frame. A field changes only when the shaft has changed, so as not to undo what the user has
    // just typed before the bus has taken it.
    void showShaft(const TrainingControls::Shaft &shaft);
    // The panel turns to another device, or to another ring.
    void leave();

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void makePosition(QGridLayout *grid);
    void makeSpeed(QGridLayout *grid);
    void turnBy(qint64 steps);
    void turnTo();
    void setSpeed(double rpm);
    void tellOfTurning();

    const SharedControls &m_controls;
    std::optional<TrainingControls::Shaft> m_shown;
    LeftAlone m_leftAlone;
    HandWheel *m_wheel;
    QLabel *m_raw;
    QLabel *m_turn;
    IntegerField *m_target;
    DecimalField *m_speed;
};

} // namespace codewheel
