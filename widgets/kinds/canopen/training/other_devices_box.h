// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/background_traffic.h"
#include "kinds/canopen/simulator/can_training_acts.h"
#include "widgets/input/number_fields.h"

#include <QWidget>

#include <optional>

class QCheckBox;

namespace codewheel {

namespace canopen {
class SimulatedCanopenPlant;
}

// What goes on beside the encoders of the simulated CAN bus: other devices, which take their part of it, and
// a master. Part of the training panel.
class OtherDevicesBox : public QWidget
{
    Q_OBJECT

public:
    explicit OtherDevicesBox(QWidget *parent = nullptr);

    // With each frame; the plant outlives it, or another one is shown first.
    void showPlant(canopen::SimulatedCanopenPlant &plant);

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void setLoad(int percent);
    void setMaster(bool on);

    canopen::SimulatedCanopenPlant *m_plant = nullptr;
    IntegerField *m_load;
    QCheckBox *m_master = nullptr;
    std::optional<canopen::BackgroundPlan> m_shown;
};

} // namespace codewheel
