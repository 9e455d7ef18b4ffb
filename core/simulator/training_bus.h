// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/process_data_link.h"
#include "simulator/training_controls.h"

#include <memory>

namespace codewheel {

// The training bus: 1.0 FRABA OCD-IB K3 (13 + 12 bit; steps 8192, revolutions 1, CW, preset 0; stands still
// at raw position 12345 until somebody moves it) and 2.0 Baumer GXP6W K3 (factory settings, turning clockwise
// at 10 rpm). Starts the same in every process.
struct TrainingBus
{
    std::unique_ptr<ProcessDataLink> link;
    std::shared_ptr<TrainingControls> controls;
};

TrainingBus makeTrainingBus();

// A ring of `count` FRABA K3 encoders, all turning: for benchmarks.
TrainingBus makeMovingRing(int count);

} // namespace codewheel
