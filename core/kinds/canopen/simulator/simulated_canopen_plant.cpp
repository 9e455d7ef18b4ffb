// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

namespace codewheel::canopen {

std::vector<CanopenEncoderPlan> trainingEncoders()
{
    using Form = CanopenEncoderPlan::Form;
    constexpr std::uint32_t twk = 0x10D; // vendor
    return {
        {.node = 5,
         .form = Form::singleTurn,
         .deviceClass = 1,
         .resolution = {.stepsPerTurn = 8192, .turns = 1},
         .raw = 5'000,
         .cyclicTimer = 100,
         .name = "SIM13-CO",
         .identity = {twk, 0x13, 0x10000, 0x0012'D591},
         .operatingTime = 12'876},
        {.node = 6,
         .raw = 12'345'678,
         .revolutionsPerMinute = 10,
         .cyclicTimer = 50,
         .heartbeat = 1'000,
         .name = "SIM25-CO",
         .identity = {twk, 0x25, 0x10001, 0x0012'D5A4},
         .operatingTime = 4'321,
         .quirks = {.hasNodeObject = true}},
        {.node = 7,
         .form = Form::linear,
         .resolution = {.stepsPerTurn = 8'000, .turns = 50}, // a metre, there and back
         .raw = 40'000,
         .revolutionsPerMinute = 6, // 4 mm/s
         .heartbeat = 1'000,
         .name = "SIMLIN-CO",
         .identity = {twk, 0x1000, 0x10000, 0x0013'0008}},
        {.raw = 20'000'000, .name = "SIM25-CO", .identity = {twk, 0x25, 0x10001, 0x0013'0015}},
    };
}

SimulatedCanopenPlant::SimulatedCanopenPlant(const std::vector<CanopenEncoderPlan> &encoders,
                                             std::uint32_t seed)
    : m_bus(std::make_shared<SimulatedCanBus>(seed))
    , m_background(std::make_shared<BackgroundTraffic>(encoders.empty() ? CanopenEncoderPlan().rate
                                                                        : encoders.front().rate))
{
    for (const CanopenEncoderPlan &plan : encoders) {
        m_nodes.push_back(std::make_shared<SimulatedNode>(plan));
        m_bus->add(m_nodes.back());
    }
    m_bus->add(m_background);
}

void SimulatedCanopenPlant::setBackground(const BackgroundPlan &plan)
{
    m_bus->locked([&] { m_background->set(plan); });
}

BackgroundPlan SimulatedCanopenPlant::background() const
{
    return m_bus->locked([this] { return m_background->plan(); });
}

} // namespace codewheel::canopen
