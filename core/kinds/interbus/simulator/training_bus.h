// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/process_data_link.h"
#include "kinds/interbus/simulator/training_controls.h"
#include "kinds/interbus/simulator/training_plan.h"

#include <memory>

namespace codewheel {

class SimulatedDevice;

// A simulated ring: the link to it and the trainer's controls. It starts the same in every process.
struct TrainingBus
{
    std::unique_ptr<ProcessDataLink> link;
    std::shared_ptr<TrainingControls> controls;
};

// The device of a participant; its description can be simulated (canBeSimulated()).
std::unique_ptr<SimulatedDevice> simulatedDevice(const TrainingParticipant &planned);

// The plant of resources/examples/training.json. The catalog must hold the built-in descriptions, and must
// outlive the plan.
TrainingPlan trainingPlan(const Catalog &catalog);

TrainingBus makeTrainingBus(const TrainingPlan &plan);
TrainingBus makeTrainingBus(const Catalog &catalog); // of trainingPlan()

// A ring of `count` FRABA K3 encoders, all turning: for benchmarks.
TrainingBus makeMovingRing(int count);

} // namespace codewheel
