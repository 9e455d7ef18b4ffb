// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_bus_terminal.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "kinds/interbus/words/device_number.h"

#include <memory>

namespace codewheel {

// A ring of FRABA K3 with a branch and a local bus, for testing faults:
// 1.0, 2.0 on the main line; terminal 3.0 with 3.1 and 3.2 on its local bus and the branch 4.0, 5.0; 6.0.
struct FaultyRing
{
    FaultyRing()
    {
        add(NodeId("1.0"), 0);
        add(NodeId("2.0"), 0);
        ring->add({.number = NodeId("3.0"), .deviceCode = 0x000C, .deviceKey = {}},
                  std::make_unique<SimulatedBusTerminal>());
        add(NodeId("3.1"), 0);
        add(NodeId("3.2"), 0);
        add(NodeId("4.0"), 1);
        add(NodeId("5.0"), 1);
        add(NodeId("6.0"), 0);
        ring->keepConfiguration(QStringLiteral("plant.codewheel"));
    }
    void add(NodeId node, int level)
    {
        const DeviceNumber number = DeviceNumber::of(node);
        const bool isLocal = number.position > 0;
        const unsigned idCode = isLocal ? 0xB3 : 0x37;
        ring->add(
            {.number = node,
             .deviceCode = 0x0200 | idCode,
             .inWords = 2,
             .outWords = 2,
             .deviceKey = isLocal ? QStringLiteral("fraba-ocd-ib-loop2") : QStringLiteral("fraba-ocd-ib"),
             .level = level},
            std::make_unique<FrabaK3>(PhysicalResolution{}, 1'000 * number.segment + number.position,
                                      FrabaPlate{}));
    }
    static constexpr std::size_t devices = 8;

    std::shared_ptr<SimulatedRing> ring = std::make_shared<SimulatedRing>();
    std::unique_ptr<ProcessDataLink> link = std::make_unique<SimulatedRingLink>(ring);
};

} // namespace codewheel
