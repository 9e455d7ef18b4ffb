// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/ring_event.h"

#include <cstdint>
#include <mutex>
#include <vector>

namespace codewheel {

// Carries events from the bus thread to the window, oldest first. Trace rows nobody takes are dropped from a
// limit on and counted; outcomes, progress and messages never are. Any thread.
class EventQueue
{
public:
    static constexpr std::size_t maximumRows = 10'000;

    void push(RingEvent event);
    std::vector<RingEvent> take();
    std::uint64_t droppedRows() const;

private:
    mutable std::mutex m_mutex;
    std::vector<RingEvent> m_events;
    std::size_t m_rows = 0;
    std::uint64_t m_droppedRows = 0;
};

} // namespace codewheel
