// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_device.h"

namespace codewheel {

// A bus terminal: a participant of the ring without data, where a branch begins.
class SimulatedBusTerminal final : public SimulatedDevice
{
public:
    Word cycle(Word) override { return 0; }
};

} // namespace codewheel
