// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

#include <deque>

namespace codewheel {

// Joins two CAN buses: what is received on one is sent on the other, in its order. Used to have simulated
// devices on a real bus.
class CanBridge
{
public:
    static constexpr std::size_t mostWaiting = 256; // frames to either side; then more are lost

    // Both open to send. The one waited for is `far`; `near` is asked without waiting.
    CanBridge(CanLink &far, CanLink &near)
        : m_far(far)
        , m_near(near)
    {}

    // Carries what there is on both, and waits for frames on the far one at most so long.
    Result<void> carry(Instant atMost);
    std::uint64_t lost() const { return m_lost; }

private:
    using Frames = std::deque<CanFrame>;

    void take(const CanNews &news, Frames &frames);
    static Result<void> sendWhatFits(CanLink &link, Frames &frames);

    CanLink &m_far;
    CanLink &m_near;
    Frames m_toFar;
    Frames m_toNear;
    std::uint64_t m_lost = 0;
};

} // namespace codewheel
