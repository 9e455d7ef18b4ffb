// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/ring_session.h"
#include "simulator/training_bus.h"

#include <memory>

namespace codewheel {

// A training ring and the trainer's hand on it.
struct TrainingSession
{
    std::shared_ptr<TrainingControls> controls;
    std::unique_ptr<RingSession> bus;
};

// Not connected yet. The catalog must outlive the session; `begin` is the date and time that Instant 0 stands
// for.
TrainingSession makeTrainingSession(const Catalog &catalog, QDateTime begin, TrainingBus training,
                                    BusId ring = firstRing);
// What the plan of the training ring knows of its encoders is told to them: that the FRABA K3 start up in
// position mode; in the window also what their positions are made of.
void tellTrainingPlan(RingSession &bus, ParameterValues TrainingParticipant::*known);
// Connected, in RUN and in Operate. Cycles come with bus->advance() or bus->startThread().
TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin, BusId ring = firstRing);

} // namespace codewheel
