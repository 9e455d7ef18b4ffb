// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/bus_session.h"
#include "simulator/training_controls.h"

#include <memory>

namespace codewheel {

// The training bus, connected, in RUN and in Operate, as window and command line both start it. Cycles come
// with bus->advance() or bus->startThread().
struct TrainingSession
{
    std::shared_ptr<TrainingControls> controls;
    std::unique_ptr<BusSession> bus;
};

// The catalog must outlive the session; `begin` is the date and time that Instant 0 stands for. What the plan
// of the training bus knows of its encoders is told to them: the FRABA K3 start up in position mode.
TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin);

} // namespace codewheel
