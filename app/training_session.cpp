// SPDX-License-Identifier: GPL-3.0-or-later
#include "training_session.h"

#include "simulator/training_bus.h"

namespace codewheel {
namespace {

constexpr DeviceNumber frabaEncoder{1, 0};
constexpr std::int64_t startsUpAsK3 = 1; // read-out 9, FRABA manual 10.2

} // namespace

TrainingSession openTrainingSession(const Catalog &catalog, QDateTime begin)
{
    TrainingBus training = makeTrainingBus();
    auto bus = std::make_unique<BusSession>(std::move(training.link), catalog, std::move(begin));
    if (!bus->open(BusSession::Start::operating)) // a simulated link always opens
        Q_UNREACHABLE();
    bus->encoder(frabaEncoder)->tell(Parameter::startUpMode, startsUpAsK3);
    return {std::move(training.controls), std::move(bus)};
}

} // namespace codewheel
