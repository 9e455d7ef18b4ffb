// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/pseudo_terminal_link.h"

#include <algorithm>

namespace codewheel {

PseudoTerminalLink::PseudoTerminalLink(PseudoTerminal terminal)
    : m_terminal(std::move(terminal))
{}

Instant PseudoTerminalLink::now() const
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now() - m_begin);
}

void PseudoTerminalLink::wait(Instant until)
{
    m_terminal.wait(m_wake.descriptor(), std::max(until - now(), Instant{}));
}

Result<void> PseudoTerminalLink::write(const QByteArray &bytes)
{
    m_terminal.write(bytes);
    return {};
}

// What a program did not fetch is not for the next one.
Result<QByteArray> PseudoTerminalLink::read(Instant until)
{
    while (true) {
        if (m_terminal.clientLeft())
            m_terminal.dropUnfetched();
        QByteArray bytes = m_terminal.read();
        if (!bytes.isEmpty() || now() >= until || m_wake.lower())
            return bytes;
        wait(until);
    }
}

} // namespace codewheel
