// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/training_bus.h"

#include "simulator/baumer_k3.h"
#include "simulator/fraba_k3.h"
#include "simulator/simulated_ring.h"

namespace codewheel {

namespace {

constexpr PhysicalResolution thirteenPlusTwelveBit{.stepsPerTurn = 8192, .turns = 4096};
constexpr Word firstSerialNumber = 20'417;
constexpr Word operatingTime = 1'234; // 10 min: 205 hours and 40 minutes
constexpr std::int64_t rawOfStillShaft = 12'345;
constexpr std::int64_t rawOfTurningShaft = 1'000'000;
constexpr double baumerSpeed = 10;      // rpm
constexpr double slowestOfRing = 100;   // rpm
constexpr double speedDifference = 7.5; // rpm from one shaft to the next
constexpr std::int64_t rawDifference = 100'003;

Participant k3At(int segment, const QString &deviceKey)
{
    return {.number = {segment, 0},
            .idCode = 0x37,
            .deviceCode = 0x0237,
            .inWords = 2,
            .outWords = 2,
            .deviceKey = deviceKey};
}

Participant frabaAt(int segment)
{
    return k3At(segment, QStringLiteral("fraba-ocd-ib"));
}

TrainingBus busOf(std::shared_ptr<SimulatedRing> ring)
{
    return {.link = std::make_unique<SimulatedRingLink>(ring), .controls = ring};
}

} // namespace

TrainingBus makeTrainingBus()
{
    auto ring = std::make_shared<SimulatedRing>();
    const FrabaPlate plate{.serialNumber = firstSerialNumber, .operatingTime = operatingTime};
    ring->add(frabaAt(1), std::make_unique<FrabaK3>(thirteenPlusTwelveBit, rawOfStillShaft, plate));

    auto baumer = std::make_unique<BaumerK3>(thirteenPlusTwelveBit, rawOfTurningShaft);
    baumer->setSpeed(baumerSpeed);
    ring->add(k3At(2, QStringLiteral("baumer-gxp6w")), std::move(baumer));
    return busOf(std::move(ring));
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
    return busOf(std::move(ring));
}

} // namespace codewheel
