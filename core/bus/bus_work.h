// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_mail.h"
#include "vocabulary/instant.h"
#include "vocabulary/refusal.h"

#include <chrono>
#include <memory>
#include <stop_token>
#include <vector>

namespace codewheel {

// How opening the link ended.
struct LinkOpened
{
    Result<void> result;
};

// What is done on a bus, turn by turn: by its thread (BusThread), or by hand. All calls come from there,
// except interrupt(), which any thread may call.
class BusWork
{
public:
    virtual ~BusWork() = default;

    // Opens the link, unless it is asked to stop. The result is reported as an event too.
    virtual Result<void> open(const std::stop_token &stop) = 0;
    // Works until `until` on the link's clock; a turn of a cyclic bus is one cycle, at that time.
    virtual void turn(Instant until) = 0;
    // The computer slept for this long, just before now: the jobs end, nothing is waiting to be sent any
    // more, and the bus is in Watch.
    virtual void slept(std::chrono::milliseconds duration) = 0;
    // Carries out what was posted, ends the jobs, and closes the link. May be called repeatedly.
    virtual void close() = 0;

    virtual Instant now() const = 0; // on the link's clock
    // Set by its thread; cycles that come late are counted.
    virtual void setPacing(std::chrono::nanoseconds /*period*/, std::uint64_t /*lateCycles*/) {}
    virtual bool keepsPace() const { return true; } // false: it waits for its link, and no cycle is late
    virtual void interrupt() = 0;                   // the call blocking in the link, or the next one
};

// Opens a link until it is open, refused, or asked to stop: an interruption may have been meant for an
// earlier call.
template <class Open>
auto openUnlessStopped(const std::stop_token &stop, Open open)
{
    auto opened = open();
    while (!opened && opened.error().kind == RefusalKind::stopped && !stop.stop_requested())
        opened = open();
    return opened;
}

// With its mail: post(), takeEvents() and takeLatest() may be called by any thread.
template <class Command, class Event, class Snapshot>
class BusRunner : public BusWork
{
public:
    using BusCommand = Command;
    using BusEvent = Event;
    using BusSnapshot = Snapshot;
    using Mail = BusMail<Command, Event, Snapshot>;

    virtual void post(Command command) { m_mail.post(std::move(command)); }
    std::vector<Event> takeEvents() { return m_mail.takeEvents(); }
    // The newest snapshot; empty if none came since the last call.
    std::shared_ptr<const Snapshot> takeLatest() { return m_mail.takeLatest(); }
    void takeShown(typename Mail::Shown &taken) { m_mail.takeShown(taken); }

protected:
    Mail m_mail;
};

} // namespace codewheel
