// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/can_bus_faults.h"
#include "kinds/canopen/simulator/can_training_acts.h"

#include <QWidget>

#include <memory>
#include <optional>

class QCheckBox;
class QPushButton;

namespace codewheel {

namespace canopen {
class SimulatedCanopenPlant;
}
class RateFields;
class SimulatedCanAdapter;

// What can happen to the simulated CAN bus: frames lost, destroyed, doubled or late, an adapter that is
// alone, goes bus off or is unplugged. Part of the training panel.
class CanFaultsBox : public QWidget
{
    Q_OBJECT

public:
    explicit CanFaultsBox(QWidget *parent = nullptr);

    // With each frame; the bus outlives it, or another one is shown first.
    void showBus(canopen::SimulatedCanopenPlant &plant, const std::shared_ptr<SimulatedCanAdapter> &adapter);

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    void setRate(std::size_t row, int count);
    void setDelay(int milliseconds);
    void setAlone(bool on);
    void setUnplugged(bool on);
    void goBusOff();
    void showFaults(const CanBusFaults &faults);
    void change(const std::function<void(CanBusFaults &)> &how);

    canopen::SimulatedCanopenPlant *m_plant = nullptr;
    std::shared_ptr<SimulatedCanAdapter> m_adapter;
    RateFields *m_rates;
    QCheckBox *m_alone = nullptr;
    QCheckBox *m_unplugged = nullptr;
    QPushButton *m_busOff;
    std::optional<CanBusFaults> m_shown;
};

} // namespace codewheel
