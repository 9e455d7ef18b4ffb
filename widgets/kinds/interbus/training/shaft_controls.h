// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/training_act.h"
#include "widgets/kinds/interbus/training/shared_controls.h"

#include <QWidget>

namespace codewheel {

class ShaftFields;

// The shaft of a simulated encoder: turned by hand, to a raw position, or at a speed. Part of the training
// panel.
class ShaftControls : public QWidget
{
    Q_OBJECT

public:
    explicit ShaftControls(const SharedControls &controls, QWidget *parent = nullptr);

    void showShaft(const TrainingControls::Shaft &shaft); // with each frame
    // The panel turns to another device, or to another ring.
    void leave();

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    const SharedControls &m_controls;
    NodeId m_number; // of the encoder that is shown
    ShaftFields *m_fields;
};

} // namespace codewheel
