// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/simulated_node.h"

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

namespace codewheel::canopen {

using Frames = std::vector<std::string>;

// Simulated nodes on a cable on which frames take no time, and somebody who sends and notes. Frames are
// written as "605#40 04 60 00 00 00 00 00", remote ones as "705#R".
class NodeBench : public testing::Test
{
protected:
    // Power comes on; its boot-up is not noted.
    SimulatedNode &add(const CanopenEncoderPlan &plan);
    SimulatedNode &node(std::size_t which = 0) { return *m_nodes.at(which); }

    // Lets time pass; what was sent meanwhile. Equal frames at the same time are one.
    Frames pass(Instant time);
    // What is sent within 2 ms.
    Frames send(const std::string &frame);
    // The same, as one frame; "" for none.
    std::string ask(const std::string &frame);
    // Node 5's value of an object; or its abort code, as "06020000".
    std::string read(const std::string &object);
    // "" where it is taken.
    std::string write(const std::string &command, const std::string &object, const std::string &value);
    std::int64_t number(const std::string &object);
    void powerCycle();

    Instant m_now{};

private:
    std::vector<std::unique_ptr<SimulatedNode>> m_nodes;
};

} // namespace codewheel::canopen
