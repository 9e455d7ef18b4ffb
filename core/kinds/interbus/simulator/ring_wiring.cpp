// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/ring_wiring.h"

#include "kinds/interbus/words/device_number.h"

#include <algorithm>

namespace codewheel {

void RingWiring::add(RingDevice participant)
{
    m_planned.push_back(std::move(participant));
    m_troubles.emplace_back();
    ++m_changes;
}

void RingWiring::setTrouble(std::size_t place, const PlaceTrouble &trouble)
{
    m_troubles[place] = trouble;
    m_hasCrcErrors =
        std::ranges::any_of(m_troubles, [](const PlaceTrouble &other) { return other.crcErrors > 0; });
    ++m_changes;
}

bool RingWiring::canBeWrong(std::size_t place) const
{
    return m_planned[place].idCode() != busTerminalIdCode;
}

// A K2 instead of anything else, a K1 instead of a K2; on Loop 2 the K2 of Loop 2.
RingDevice RingWiring::present(std::size_t place) const
{
    RingDevice participant = m_planned[place];
    participant.deviceKey.clear();
    if (!m_troubles[place].wrongDevice)
        return participant;
    const bool isLocal = DeviceNumber::of(participant.number).position > 0;
    const unsigned k2 = isLocal ? 0xB2 : 0x36;
    const int words = participant.deviceCode == (0x0200U | k2) ? 1 : 2;
    participant.deviceCode = static_cast<unsigned>(words) << 8 | k2;
    participant.inWords = words;
    participant.outWords = 0;
    return participant;
}

std::vector<std::size_t> RingWiring::reachable() const
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < size();) {
        const bool isCutOff = m_troubles[i].wireBroken || !m_troubles[i].supplied;
        if (!isCutOff)
            found.push_back(i);
        i = isCutOff ? endOfCutOff(m_planned, i) : i + 1;
    }
    return found;
}

std::size_t endOfCutOff(const RingStructure &ring, std::size_t place)
{
    const RingDevice &first = ring[place];
    const bool isLocal = DeviceNumber::of(first.number).position > 0;
    std::size_t end = place + 1;
    while (end < ring.size() &&
           (isLocal ? DeviceNumber::of(ring[end].number).segment == DeviceNumber::of(first.number).segment
                    : ring[end].level >= first.level))
        ++end;
    return end;
}

} // namespace codewheel
