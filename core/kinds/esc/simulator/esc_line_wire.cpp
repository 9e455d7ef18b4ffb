// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/esc_line_wire.h"

#include <algorithm>

namespace codewheel {

// A lost character leaves a gap; a doubled one delays the others.
void EscLineWire::send(const QByteArray &bytes, int sender, Instant earliest, const SerialSettings &settings)
{
    Instant begin = std::max(earliest, m_freeFrom[sender]);
    int sent = 0;
    const auto put = [&](char byte) {
        const Instant from = begin + settings.timeOf(sent);
        this->put(begin + settings.timeOf(++sent), {from, sender, settings.baudRate, byte});
    };
    for (const char byte : bytes) {
        if (strikes(m_faults.delayed))
            begin += m_faults.delay;
        if (strikes(m_faults.lost)) {
            ++sent;
            continue;
        }
        const char heard = strikes(m_faults.corrupted) ? corrupted(byte) : byte;
        put(heard);
        if (strikes(m_faults.doubled))
            put(heard);
    }
    m_freeFrom[sender] = begin + settings.timeOf(sent);
}

void EscLineWire::put(Instant end, Character character)
{
    for (auto each = m_characters.upper_bound(character.begin); each != m_characters.end(); ++each) {
        Character &other = each->second;
        if (other.sender != character.sender && other.begin < end)
            other.spoiled = character.spoiled = true;
    }
    m_characters.emplace(end, character);
}

std::optional<Instant> EscLineWire::nextEnd() const
{
    if (m_characters.empty())
        return std::nullopt;
    return m_characters.begin()->first;
}

std::optional<Instant> EscLineWire::runEnd() const
{
    std::optional<Instant> end = nextEnd();
    for (const auto &[itsEnd, character] : m_characters) {
        if (character.begin > *end)
            break;
        end = itsEnd;
    }
    return end;
}

EscLineWire::Ended EscLineWire::take()
{
    const auto node = m_characters.extract(m_characters.begin());
    return {node.key(), node.mapped()};
}

void EscLineWire::clear()
{
    m_characters.clear();
    m_freeFrom.clear();
}

} // namespace codewheel
