// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/served_can_bus.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant untilPortHasRoom = 10ms;
constexpr int mostPiecesOfCommands = 16; // others want their turn, too

} // namespace

std::optional<Instant> ServedCanBus::serve(Instant now)
{
    if (m_port.clientLeft()) {
        m_port.dropUnfetched();
        m_adapter.restart();
    }
    m_adapter.advance(now);
    for (int piece = 0; piece < mostPiecesOfCommands; ++piece) {
        const QByteArray bytes = m_port.read();
        if (bytes.isEmpty())
            break;
        m_adapter.take(bytes, now);
    }
    if (!m_adapter.unfetched().isEmpty())
        m_adapter.fetched(m_port.write(m_adapter.unfetched()));
    const std::optional<Instant> next = m_bus.nextEvent();
    if (m_adapter.unfetched().isEmpty())
        return next;
    return std::min(next.value_or(Instant::max()), now + untilPortHasRoom);
}

} // namespace codewheel
