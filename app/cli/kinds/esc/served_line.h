// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/pseudo_terminal.h"
#include "kinds/esc/simulator/simulated_esc_line.h"

namespace codewheel {

// A simulated line behind a pseudo terminal, as seen by another program: what it writes goes out at the speed
// of the line, and comes back as answers. What is written faster than the line carries is dropped once
// `mostWaiting` characters wait, as with a port without flow control, and nothing of it is left for the next
// program. Used by the command serve; time is an argument.
class ServedLine
{
public:
    static constexpr std::size_t mostWaiting = 512; // 0.3 s at 19200 Bd

    ServedLine(SimulatedEscLine &line, PseudoTerminal &port)
        : m_line(line)
        , m_port(port)
    {}

    // Does what is due at `now`; returns when there will be more, if nobody writes.
    std::optional<Instant> serve(Instant now);

private:
    void takeWritten(Instant now);
    void forgetLastClient(Instant now);

    SimulatedEscLine &m_line;
    PseudoTerminal &m_port;
    bool m_isFlooded = false; // by the program that has the port open
};

} // namespace codewheel
