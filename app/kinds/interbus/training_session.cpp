// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_session.h"

namespace codewheel {

TrainingSession makeTrainingSession(const Catalog &catalog, QDateTime begin, TrainingBus training, BusId ring)
{
    auto bus = std::make_unique<RingSession>(std::move(training.link), catalog, std::move(begin), nullptr,
                                             RingSession::DriverFactory(), ring);
    return {std::move(training.controls), std::move(bus)};
}

void tellTrainingPlan(RingSession &bus, ParameterValues TrainingParticipant::*known)
{
    for (const TrainingParticipant &planned : trainingPlan(bus.catalog()))
        for (const ParameterValue &value : planned.*known)
            if (EncoderSession *encoder = bus.encoder(planned.number))
                encoder->tell(value.parameter, value.value);
}

TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin, BusId ring)
{
    TrainingSession training = makeTrainingSession(catalog, std::move(begin), makeTrainingBus(catalog), ring);
    if (!training.bus->open(RingSession::Start::operating)) // a simulated link always opens
        Q_UNREACHABLE();
    tellTrainingPlan(*training.bus, &TrainingParticipant::known);
    return training;
}

} // namespace codewheel
