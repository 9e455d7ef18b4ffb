// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/simulated_can_bus.h"
#include "kinds/canopen/simulator/background_traffic.h"
#include "kinds/canopen/simulator/simulated_node.h"

namespace codewheel::canopen {

// The encoders of the training bus: single-turn of class 1 as node 5, multi-turn of class 2 as node 6, a
// linear one as node 7, and one without a number.
std::vector<CanopenEncoderPlan> trainingEncoders();

// A simulated CAN bus with CANopen encoders on it. Any thread.
class SimulatedCanopenPlant
{
public:
    explicit SimulatedCanopenPlant(const std::vector<CanopenEncoderPlan> &encoders = trainingEncoders(),
                                   std::uint32_t seed = 1);

    const std::shared_ptr<SimulatedCanBus> &bus() const { return m_bus; } // for a SimulatedCanLink

    // For the trainer.
    std::size_t count() const { return m_nodes.size(); }
    // On the wire, before whoever comes to the bus later.
    std::size_t participants() const { return m_nodes.size() + 1; }
    void setBackground(const BackgroundPlan &plan);
    BackgroundPlan background() const;
    // Calls `change` with an encoder, counted from 0 in the order of the plans.
    template <typename Change>
    auto withEncoder(std::size_t which, Change change)
    {
        return m_bus->locked([&] { return change(*m_nodes.at(which)); });
    }

private:
    std::shared_ptr<SimulatedCanBus> m_bus;
    std::vector<std::shared_ptr<SimulatedNode>> m_nodes;
    std::shared_ptr<BackgroundTraffic> m_background;
};

} // namespace codewheel::canopen
