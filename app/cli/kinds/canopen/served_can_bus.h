// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/simulated_slcan_adapter.h"
#include "cli/bus/pseudo_terminal.h"

namespace codewheel {

// A simulated CAN bus behind a pseudo terminal, on which an SLCAN adapter answers. Whoever has it open is the
// only one: when the last program closes it, the adapter begins anew. Used by the command serve; time is an
// argument.
class ServedCanBus
{
public:
    ServedCanBus(SimulatedCanBus &bus, SimulatedSlcanAdapter &adapter, PseudoTerminal &port)
        : m_bus(bus)
        , m_adapter(adapter)
        , m_port(port)
    {}

    // Does what is due at `now`; returns when there will be more, if nobody writes.
    std::optional<Instant> serve(Instant now);

private:
    SimulatedCanBus &m_bus;
    SimulatedSlcanAdapter &m_adapter;
    PseudoTerminal &m_port;
};

} // namespace codewheel
