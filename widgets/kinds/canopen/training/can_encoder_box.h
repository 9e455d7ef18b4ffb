// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/can_training_acts.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QLabel;

namespace codewheel {

class CanQuirkBoxes;
class ShaftFields;

// A simulated encoder of the CAN bus: its shaft, what can happen to it, and what its make does otherwise.
// Part of the training panel.
class CanEncoderBox : public QWidget
{
    Q_OBJECT

public:
    explicit CanEncoderBox(QWidget *parent = nullptr);

    // With each frame, by its number in the plant, which outlives it, or another one is shown first.
    void showEncoder(canopen::SimulatedCanopenPlant &plant, std::size_t which);
    void leave(); // another one is about to be shown

Q_SIGNALS:
    void acted(const codewheel::TrainingAct &what);

private:
    using Node = canopen::SimulatedNode;

    void followShaft();
    void set(NodeTrouble trouble, bool ticked);
    void change(const std::function<void(Node &)> &how);

    canopen::SimulatedCanopenPlant *m_plant = nullptr;
    std::size_t m_which = 0;
    ShaftFields *m_shaft;
    QLabel *m_writes;
    std::vector<QCheckBox *> m_troubles; // by NodeTrouble
    CanQuirkBoxes *m_quirks;
};

} // namespace codewheel
