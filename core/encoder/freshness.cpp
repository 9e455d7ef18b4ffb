// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/freshness.h"

namespace codewheel {
namespace {

using Reason = Freshness::Reason;

// The nearest cause first, since that is the one something can be done about.
Reason reasonOf(Instant seen, const Freshness::Circumstances &bus)
{
    if (!bus.isConnected)
        return Reason::disconnected;
    if (!bus.isLinkThere)
        return Reason::linkLost;
    if (!bus.isOnBus)
        return Reason::notOnBus;
    if (!bus.isRunning)
        return Reason::stopped;
    if (seen < bus.awakeSince)
        return Reason::slept;
    return bus.now - seen > Freshness::lateAfter ? Reason::notAsked : Reason::none;
}

std::optional<Instant> seenAt(const Reading &reading)
{
    return reading.state == EncoderState::notSeen ? std::nullopt : std::optional(reading.at);
}

} // namespace

Freshness::Freshness(std::optional<Instant> seen, const Circumstances &bus)
{
    if (!seen)
        return;
    m_seen = *seen;
    m_reason = reasonOf(m_seen, bus);
    m_state = m_reason == Reason::none ? State::live : State::old;
}

Freshness::Freshness(const Reading &reading, const Circumstances &bus)
    : Freshness(seenAt(reading), bus)
{
    const bool mayBeLive = isLive() || m_reason == Reason::notAsked || m_reason == Reason::slept;
    if (reading.state != EncoderState::silent || !mayBeLive)
        return;
    m_state = State::old;
    m_reason = Reason::silent;
}

} // namespace codewheel
