// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms of a simulated node, and what it tells and keeps of its errors.
#include "kinds/canopen/simulator/simulated_node.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {
namespace {

constexpr std::uint32_t noEmcyBit = 1U << 31; // of 1014h

} // namespace

void SimulatedNode::setAlarms(std::uint16_t alarms)
{
    constexpr int bits = 16;
    m_isTouched = true;
    const std::uint16_t before = std::exchange(m_alarms, alarms);
    if (!isRunning())
        return;
    for (int bit = 0; bit < bits; ++bit) {
        // Hardware, for the position; what is its maker's otherwise. Both are assumed.
        const Error error = bit == 0 ? Error{.code = 0x5000, .bits = 0x21}
                                     : Error{.code = static_cast<std::uint16_t>(0xFF00 + bit), .bits = 0x81};
        const bool is = (alarms >> bit & 1) != 0;
        if (is && (before >> bit & 1) == 0)
            raise(error);
        else if (!is)
            clear(error);
    }
}

void SimulatedNode::setWarnings(std::uint16_t warnings)
{
    m_isTouched = true;
    m_warnings = warnings;
}

void SimulatedNode::raise(const Error &error)
{
    if (std::ranges::find(m_errors, error) != m_errors.end())
        return;
    m_errors.push_back(error);
    const auto kept = std::min<std::int64_t>(m_objects.number(0x1003) + 1, mostErrorsKept);
    for (auto sub = static_cast<std::uint8_t>(kept); sub > 1; --sub)
        m_objects.set(0x1003, sub, m_objects.number(0x1003, static_cast<std::uint8_t>(sub - 1)));
    m_objects.set(0x1003, 1, error.code);
    m_objects.set(0x1003, 0, kept);
    tellError(error.code);
}

void SimulatedNode::clear(const Error &error)
{
    if (std::erase(m_errors, error) != 0)
        tellError(0);
}

void SimulatedNode::tellError(std::uint16_t code)
{
    std::uint8_t bits = 0;
    for (const Error &each : m_errors)
        bits |= each.bits;
    m_objects.set(0x1001, 0, bits);
    const std::uint32_t identifier = m_objects.word(0x1014);
    if ((identifier & noEmcyBit) != 0 || m_state == NmtState::stopped)
        return;
    const std::array<std::uint8_t, 8> data{static_cast<std::uint8_t>(code),
                                           static_cast<std::uint8_t>(code >> 8), bits};
    send(identifier & largestStandardId, data);
}

} // namespace codewheel::canopen
