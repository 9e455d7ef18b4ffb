// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_la66.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"

namespace codewheel::test {

inline constexpr Place rodPlace = "5.0"_ring;
inline constexpr double rodMillimetres = 500;

// A FRABA encoder at 1.0, and at 5.0 a TR LA-66 as delivered, with its magnet at the head.
inline TrainingBus makeRodBus(const Catalog &)
{
    const auto participant = [](Place number, unsigned idCode, const char *key) {
        return RingDevice{.number = number.node,
                          .deviceCode = 0x0200 | idCode,
                          .inWords = 2,
                          .outWords = 2,
                          .deviceKey = QString::fromLatin1(key)};
    };
    auto ring = std::make_shared<SimulatedRing>();
    ring->add(participant(fraba, 0x37, "fraba-ocd-ib"),
              std::make_unique<FrabaK3>(PhysicalResolution{.stepsPerTurn = 8192, .turns = 4096}, 12'345,
                                        FrabaPlate{.serialNumber = 20'417, .operatingTime = 0}));
    ring->add(participant(rodPlace, 0x33, "tr-la66"), std::make_unique<SimulatedLa66>(rodMillimetres));
    return {.link = std::make_unique<SimulatedRingLink>(ring), .controls = ring};
}

} // namespace codewheel::test
