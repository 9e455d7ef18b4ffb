// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"
#include "widgets/input/number_fields.h"
#include "widgets/kinds/interbus/training/shared_controls.h"
#include "widgets/training/left_alone.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace codewheel {

// The magnet of a simulated linear encoder: moved along its rod by hand, to a place, or at a speed, and taken
// out of range. Part of the training panel.
class RodControls : public QWidget
{
    Q_OBJECT

public:
    explicit RodControls(const SharedControls &controls, QWidget *parent = nullptr);

    // With each frame. A field changes only when the rod has changed, so as not to undo what the user has
    // just typed before the bus has taken it.
    void showRod(const TrainingControls::Rod &rod);
    // The panel turns to another device, or to another ring.
    void leave();

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void makePlace(QGridLayout *grid);
    void makeSpeed(QGridLayout *grid);
    void showPlace(double millimetres);
    void slide(int tenths);
    void moveTo();
    void setSpeed(double millimetresPerSecond);
    void setInRange(bool inRange);
    void tellOfMoving();

    const SharedControls &m_controls;
    std::optional<TrainingControls::Rod> m_shown;
    LeftAlone m_leftAlone;
    QSlider *m_track; // in tenths of mm
    QLabel *m_place;
    DecimalField *m_target;
    DecimalField *m_speed;
    QCheckBox *m_inRange;
};

} // namespace codewheel
