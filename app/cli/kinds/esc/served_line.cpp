// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/served_line.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int mostPieces = 1'000; // more than the system keeps; then the next one may already be writing

// A rate that no encoder has stands for those the terminal does not know.
int usableRate(int baudRate)
{
    constexpr int noRateOfTheirs = 19'201;
    return baudRate > 0 ? baudRate : noRateOfTheirs;
}

} // namespace

std::optional<Instant> ServedLine::serve(Instant now)
{
    if (m_port.clientLeft())
        forgetLastClient(now);
    for (auto arrived = m_line.advance(now); !arrived.bytes.isEmpty(); arrived = m_line.advance(now))
        m_port.write(arrived.bytes);
    takeWritten(now);
    return m_line.nextEnd();
}

void ServedLine::takeWritten(Instant now)
{
    const QByteArray bytes = m_port.read();
    m_line.setBaudRate(usableRate(m_port.baudRate())); // after reading: it was set before they were written
    const auto waiting = static_cast<qsizetype>(m_line.waiting());
    const qsizetype room = std::max(static_cast<qsizetype>(mostWaiting) - waiting, qsizetype{0});
    m_isFlooded = m_isFlooded || bytes.size() > room;
    if (!bytes.isEmpty())
        m_line.send(bytes.first(std::min(bytes.size(), room)), now);
}

// What it did not read, and what it wrote beyond what the line carries.
void ServedLine::forgetLastClient(Instant now)
{
    m_port.dropUnfetched();
    if (!std::exchange(m_isFlooded, false))
        return;
    for (int piece = 0; piece < mostPieces && !m_port.read().isEmpty(); ++piece)
        ;
    m_line.begin(m_line.settings(), now);
}

} // namespace codewheel
