// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/freshness.h"

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
    if (!bus.isSettled)
        return Reason::unsettled;
    if (seen < bus.awakeSince)
        return Reason::slept;
    if (bus.now - seen <= bus.lateAfter)
        return Reason::none;
    return bus.isAnswering || bus.whyNotAsked != Reason::notAsked ? bus.whyNotAsked : Reason::silent;
}

// One that is silent, or not seen any more, keeps the position it showed last.
std::optional<Instant> seenAt(const Reading &reading)
{
    const bool isAway = reading.state == EncoderState::notSeen || reading.state == EncoderState::silent;
    return isAway && !reading.position ? std::nullopt : std::optional(reading.at);
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
    const bool isSilent = reading.state == EncoderState::silent;
    if (isSilent && m_state == State::unknown && bus.isConnected && bus.isLinkThere && bus.isRunning)
        m_reason = Reason::silent;
    const bool mayBeLive = isLive() || isOnlyNotAsked(m_reason) || m_reason == Reason::slept;
    if (!mayBeLive || (!isSilent && reading.state != EncoderState::notSeen))
        return;
    m_state = State::old;
    m_reason = isSilent ? Reason::silent : Reason::notSeen;
}

Freshness Freshness::ofRecording(std::optional<Instant> at)
{
    Freshness made;
    made.m_state = at ? State::old : State::unknown;
    made.m_reason = at ? Reason::recorded : Reason::notRecorded;
    made.m_seen = at.value_or(Instant{});
    return made;
}

} // namespace codewheel
