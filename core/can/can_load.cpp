// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_load.h"

#include "can/can_bits.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant loadWindow = std::chrono::seconds(1);
constexpr int errorFrameBits = 6 + 6 + 8; // flag, answered by others one after the other, delimiter

} // namespace

void CanLoad::add(const CanFrame &frame)
{
    const Instant at = frame.time.value_or(m_taken.empty() ? Instant() : m_taken.back().at);
    const int bits = (frame.isError ? errorFrameBits : canBits(frame)) + canIntermission;
    m_taken.push_back({at, bits});
    m_bits += bits;
    forget(at - loadWindow);
}

double CanLoad::share(Instant now)
{
    forget(now - loadWindow);
    return std::min(static_cast<double>(m_bits) / m_rate, 1.0);
}

void CanLoad::forget(Instant upTo)
{
    while (!m_taken.empty() && m_taken.front().at <= upTo) {
        m_bits -= m_taken.front().bits;
        m_taken.pop_front();
    }
}

} // namespace codewheel
