// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_session.h"

#include "simulator/training_bus.h"

namespace codewheel {

TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin)
{
    const TrainingPlan plan = trainingPlan(catalog);
    TrainingBus training = makeTrainingBus(plan);
    auto bus = std::make_unique<BusSession>(std::move(training.link), catalog, std::move(begin));
    if (!bus->open(BusSession::Start::operating)) // a simulated link always opens
        Q_UNREACHABLE();
    for (const TrainingParticipant &planned : plan)
        for (const ParameterValue &value : planned.known)
            bus->encoder(planned.number)->tell(value.parameter, value.value);
    return {std::move(training.controls), std::move(bus)};
}

} // namespace codewheel
