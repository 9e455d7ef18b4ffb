// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"

#include <memory>

namespace codewheel {

// A training ring with the trainer's controls.
struct TrainingSession
{
    std::shared_ptr<TrainingControls> controls;
    std::unique_ptr<RingSession> bus;
};

// Not connected yet. The catalog must outlive the session; `begin` is the date and time of Instant 0.
TrainingSession makeTrainingSession(const Catalog &catalog, QDateTime begin, TrainingBus training,
                                    BusId ring = firstBus);
// Tells the encoders what the training plan knows of them: that the FRABA K3 start in position mode; in the
// window also what their positions are made of.
void tellTrainingPlan(RingSession &bus, ParameterValues TrainingParticipant::*known);
// Connected, in RUN and in Operate. Cycles come with bus->advance() or bus->startThread().
TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin, BusId ring = firstBus);

} // namespace codewheel
