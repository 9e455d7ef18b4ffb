// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_bus.h"

#include "catalog/protocol_rules.h"
#include "kinds/interbus/simulator/baumer_k3.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_bus_terminal.h"
#include "kinds/interbus/simulator/simulated_la66.h"
#include "kinds/interbus/simulator/simulated_position_encoder.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/profiles.h"

#include <QFile>

namespace codewheel {

namespace {

constexpr PhysicalResolution thirteenPlusTwelveBit{.stepsPerTurn = 8192, .turns = 4096};
constexpr Word firstSerialNumber = 20'417;
constexpr Word operatingTime = 1'234;   // 10 min: 205 hours and 40 minutes
constexpr double slowestOfRing = 100;   // rpm
constexpr double speedDifference = 7.5; // rpm from one shaft to the next
constexpr std::int64_t rawDifference = 100'003;

RingDevice frabaAt(int segment)
{
    return {.number = DeviceNumber{segment, 0}.node(),
            .deviceCode = 0x0237,
            .inWords = 2,
            .outWords = 2,
            .deviceKey = QStringLiteral("fraba-ocd-ib")};
}

RingDevice participantOf(const TrainingParticipant &planned)
{
    if (!planned.device)
        return {.number = planned.number,
                .deviceCode = busTerminalIdCode,
                .inWords = 0,
                .outWords = 0,
                .deviceKey = {}};
    const DeviceDescription &device = *planned.device;
    return {.number = planned.number,
            .deviceCode = device.deviceCode,
            .inWords = device.inWords,
            .outWords = device.outWords,
            .deviceKey = device.key};
}

std::unique_ptr<SimulatedDevice> encoderOf(const TrainingParticipant &planned)
{
    const DeviceDescription &device = *planned.device;
    const PhysicalResolution resolution{.stepsPerTurn = device.physicalStepsPerTurn,
                                        .turns = device.physicalTurns};
    if (onlyTellsPosition(device))
        return std::make_unique<SimulatedPositionEncoder>(resolution, planned.position);
    if (device.dialect == k3::Dialect::baumer)
        return std::make_unique<BaumerK3>(resolution, planned.position);
    const FrabaPlate plate{.serialNumber = static_cast<Word>(planned.serialNumber),
                           .operatingTime = static_cast<Word>(planned.operatingTime)};
    return std::make_unique<FrabaK3>(resolution, planned.position, plate);
}

std::unique_ptr<SimulatedDevice> rodOf(const TrainingParticipant &planned)
{
    auto rod = std::make_unique<SimulatedLa66>(static_cast<double>(planned.rodMillimetres));
    rod->moveMagnetTo(static_cast<double>(planned.millimetres));
    rod->setMagnetSpeed(static_cast<double>(planned.millimetresPerSecond));
    return rod;
}

TrainingBus busOf(const std::shared_ptr<SimulatedRing> &ring)
{
    return {.link = std::make_unique<SimulatedRingLink>(ring), .controls = ring};
}

} // namespace

std::unique_ptr<SimulatedDevice> simulatedDevice(const TrainingParticipant &planned)
{
    if (!planned.device)
        return std::make_unique<SimulatedBusTerminal>();
    if (planned.device->profile == profile::la66)
        return rodOf(planned);
    auto encoder = encoderOf(planned);
    encoder->setSpeed(static_cast<double>(planned.revolutionsPerMinute));
    return encoder;
}

TrainingPlan trainingPlan(const Catalog &catalog)
{
    QFile file(QStringLiteral(":/examples/training.json"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(file.fileName()));
    auto plan = readTrainingPlan(file.readAll(), file.fileName(), catalog);
    if (!plan)
        qFatal("%s:%d: %s: %s", qPrintable(plan.error().file), plan.error().line,
               qPrintable(plan.error().key), qPrintable(plan.error().reason));
    return *std::move(plan);
}

TrainingBus makeTrainingBus(const TrainingPlan &plan)
{
    auto ring = std::make_shared<SimulatedRing>();
    for (const TrainingParticipant &planned : plan)
        ring->add(participantOf(planned), simulatedDevice(planned));
    ring->keepConfiguration(QStringLiteral("training.json"));
    return busOf(ring);
}

TrainingBus makeTrainingBus(const Catalog &catalog)
{
    return makeTrainingBus(trainingPlan(catalog));
}

TrainingBus makeMovingRing(int count)
{
    auto ring = std::make_shared<SimulatedRing>();
    for (int i = 0; i < count; ++i) {
        const FrabaPlate plate{.serialNumber = firstSerialNumber + static_cast<Word>(i),
                               .operatingTime = operatingTime};
        auto encoder = std::make_unique<FrabaK3>(thirteenPlusTwelveBit, i * rawDifference, plate);
        encoder->setSpeed(slowestOfRing + i * speedDifference);
        ring->add(frabaAt(i + 1), std::move(encoder));
    }
    return busOf(ring);
}

} // namespace codewheel
