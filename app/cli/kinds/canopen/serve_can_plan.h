// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/can_bus_faults.h"
#include "cli/call/arguments.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

namespace codewheel {

// What serve canopen was told.
struct ServeCanPlan
{
    std::optional<QString> interface {}; // empty: an SLCAN adapter on a pseudo terminal
    int rate = 125'000;                  // Bd
    CanBusFaults faults{};
    canopen::BackgroundPlan background{};
    std::uint32_t seed = 1;
    std::vector<canopen::CanopenEncoderPlan> encoders{};
    std::vector<std::size_t> silent{}; // of the encoders
};

std::span<const Option> serveCanOptions();
// "autostart, fixed-mapping, ...": what --quirk may name.
QString quirkNames();
Checked<ServeCanPlan> serveCanPlan(const Arguments &arguments);

} // namespace codewheel
