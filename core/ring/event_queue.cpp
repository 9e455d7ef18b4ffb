// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/event_queue.h"

#include <utility>

namespace codewheel {

void EventQueue::push(RingEvent event)
{
    const std::scoped_lock lock(m_mutex);
    if (std::holds_alternative<Exchange>(event.what)) {
        if (m_rows == maximumRows) {
            ++m_droppedRows;
            return;
        }
        ++m_rows;
    }
    m_events.push_back(std::move(event));
}

std::vector<RingEvent> EventQueue::take()
{
    const std::scoped_lock lock(m_mutex);
    m_rows = 0;
    return std::exchange(m_events, {});
}

std::uint64_t EventQueue::droppedRows() const
{
    const std::scoped_lock lock(m_mutex);
    return m_droppedRows;
}

} // namespace codewheel
