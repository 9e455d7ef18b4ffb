// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/value_tap.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace codewheel {

// What the thread of a bus and its session hand to each other: commands in order, events back, oldest first,
// and the newest snapshot. No signal crosses between them, and neither waits for the other. Any thread.
//
// Events that are merely rows (Event::isRow()), and what devices show, are dropped beyond a limit when nobody
// takes them, and counted; outcomes, faults and messages never are. A snapshot that was not taken makes way
// for a newer one through Snapshot::giveWayTo().
template <class Command, class Event, class Snapshot>
class BusMail
{
public:
    static constexpr std::size_t maximumRows = [] {
        if constexpr (requires { Event::mostRows; })
            return Event::mostRows;
        else
            return std::size_t{10'000};
    }();
    static constexpr std::size_t maximumShown = 500'000; // of 512 encoders in one second

    // What was shown since they were taken, oldest first, and how many came after them that nobody has.
    struct Shown
    {
        std::vector<DeviceValues> shown;
        std::uint64_t dropped = 0;
    };

    void post(Command command)
    {
        const std::scoped_lock lock(m_mutex);
        m_commands.push_back(std::move(command));
    }
    std::optional<Command> nextCommand()
    {
        const std::scoped_lock lock(m_mutex);
        if (m_commands.empty())
            return std::nullopt;
        std::optional<Command> next(std::move(m_commands.front()));
        m_commands.pop_front();
        return next;
    }

    bool hasCommands() const
    {
        const std::scoped_lock lock(m_mutex);
        return !m_commands.empty();
    }

    void tell(Event event)
    {
        const std::scoped_lock lock(m_mutex);
        if (event.isRow() && ++m_rows > maximumRows)
            ++m_droppedRows;
        else
            m_events.push_back(std::move(event));
    }
    std::vector<Event> takeEvents()
    {
        std::vector<Event> taken;
        const std::scoped_lock lock(m_mutex);
        taken.reserve(m_events.size()); // as many may come until the next call
        std::swap(taken, m_events);
        m_rows = 0;
        return taken;
    }
    std::uint64_t droppedRows() const
    {
        const std::scoped_lock lock(m_mutex);
        return m_droppedRows;
    }

    void note(const std::vector<DeviceValues> &shown)
    {
        if (shown.empty())
            return;
        const std::scoped_lock lock(m_mutex);
        if (m_shown.dropped > 0 || m_shown.shown.size() + shown.size() > maximumShown)
            m_shown.dropped += shown.size();
        else
            m_shown.shown.insert(m_shown.shown.end(), shown.begin(), shown.end());
    }
    // Into `taken`, whose memory is used again.
    void takeShown(Shown &taken)
    {
        taken.shown.clear();
        taken.dropped = 0;
        const std::scoped_lock lock(m_mutex);
        std::swap(taken, m_shown);
    }

    // Allocates only if the last snapshot was taken.
    void publish(const Snapshot &newest)
    {
        const std::scoped_lock lock(m_mutex);
        if (m_untaken)
            m_untaken->giveWayTo(newest);
        else
            m_untaken = std::make_shared<Snapshot>(newest);
    }
    // Empty if nothing was published since.
    std::shared_ptr<const Snapshot> takeLatest()
    {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_untaken, nullptr);
    }

private:
    mutable std::mutex m_mutex;
    std::deque<Command> m_commands;
    std::vector<Event> m_events;
    std::size_t m_rows = 0; // posted since events were last taken
    std::uint64_t m_droppedRows = 0;
    Shown m_shown;
    std::shared_ptr<Snapshot> m_untaken;
};

} // namespace codewheel
