// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulator/simulated_device.h"

namespace codewheel {

// A bus terminal: a participant of the ring without data, from which a branch goes off.
class SimulatedBusTerminal final : public SimulatedDevice
{
public:
    Word cycle(Word) override { return 0; }
};

} // namespace codewheel
