// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_state.h"
#include "bus/bus_thread.h"
#include "bus/bus_work.h"
#include "bus/value_tap.h"
#include "vocabulary/encoder_session.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace codewheel {

// What lies under the session of any bus: its runner, driven by a thread or by hand, and the path of its
// events into the session. It lives in the session's thread.
//
// The session, an EncoderBus, provides for it: showLatest(), dispatch(event), linkOpened(), showing(device),
// the encoder that reports what the device showed, and, where not everything is to be reported in turn,
// takeAtOnce(event) and isOfNow(snapshot).
template <class Runner, class Session>
class BusEngine
{
public:
    using Command = typename Runner::BusCommand;
    using Event = typename Runner::BusEvent;
    using Snapshot = typename Runner::BusSnapshot;

    explicit BusEngine(Session &session)
        : m_session(session)
    {}
    ~BusEngine()
    {
        if (m_runner)
            endWork();
    }
    BusEngine(const BusEngine &) = delete;
    BusEngine &operator=(const BusEngine &) = delete;

    BusState state() const { return m_state; }
    bool isBegun() const { return m_runner != nullptr; } // opening, or open
    const std::shared_ptr<const Snapshot> &latest() const { return m_latest; }
    void setLatest(std::shared_ptr<const Snapshot> latest)
    {
        m_latest = std::move(latest);
        m_latestIsNew = false;
    }
    std::deque<Event> &waiting() { return m_events; } // taken, not yet reported

    // Opens the link: with a pacing in a thread, which reports the end of it to the session; otherwise at
    // once.
    Result<void> open(std::unique_ptr<Runner> runner, std::optional<Pacing> pacing)
    {
        m_runner = std::move(runner);
        m_state = BusState::opening;
        ++m_opened;
        m_events.clear();
        m_latestIsNew = false;
        if (pacing) {
            m_thread = std::make_unique<BusThread>(*m_runner, *std::move(pacing), false);
            m_session.tellState();
            return {};
        }
        Result<void> opened = m_runner->open({});
        for (const Event &event : m_runner->takeEvents())
            tell(event);
        return opened;
    }
    // From now on by a thread.
    void startThread(Pacing pacing)
    {
        if (m_state == BusState::open && !m_thread)
            m_thread = std::make_unique<BusThread>(*m_runner, std::move(pacing), true);
    }
    // False: it was already closed, or was closed or opened again by a handler of what is reported at the
    // end.
    bool close()
    {
        if (!m_runner)
            return false;
        if (m_state == BusState::opening)
            m_state = BusState::closed; // what its thread reports now comes too late
        endWork();
        const unsigned opened = m_opened;
        pump();
        if (!m_runner || m_opened != opened)
            return false;
        m_runner.reset();
        m_state = BusState::closed;
        return true;
    }

    void post(Command command)
    {
        if (m_runner)
            m_runner->post(std::move(command));
    }

    // By hand, in turns no longer than `longestTurn`.
    void advance(Instant duration, Instant longestTurn)
    {
        if (m_state != BusState::open || m_thread)
            return;
        const Instant end = m_runner->now() + duration;
        while (m_runner->now() < end)
            m_runner->turn(std::min(end, m_runner->now() + longestTurn));
        pump();
    }

    // A handler may pump again, start a job or close: the outer call reports in turn what comes of it.
    void pump()
    {
        if (!m_runner)
            return;
        fetch();
        if (m_isPumping)
            return;
        const QScopedValueRollback pumping(m_isPumping, true);
        showValues();
        while (m_latestIsNew || !m_events.empty()) {
            const bool isNew = std::exchange(m_latestIsNew, false);
            if (isNew)
                m_session.showLatest();
            while (!m_events.empty()) {
                const Event event = std::move(m_events.front());
                m_events.pop_front();
                tell(event);
            }
            if (isNew)
                Q_EMIT m_session.updated();
        }
    }
    bool isPumping() const { return m_isPumping; }

private:
    void endWork()
    {
        if (m_thread)
            m_thread.reset();
        else
            m_runner->close();
    }

    void fetch()
    {
        for (Event &event : m_runner->takeEvents())
            if (!isTakenAtOnce(event))
                m_events.push_back(std::move(event));
        if (m_state != BusState::open) // a frame can wait until that is reported
            return;
        auto newest = m_runner->takeLatest();
        if (!newest || !isOfNow(*newest))
            return;
        m_latest = std::move(newest);
        m_latestIsNew = true;
    }
    bool isTakenAtOnce(const Event &event)
    {
        if constexpr (requires { m_session.takeAtOnce(event); })
            return m_session.takeAtOnce(event);
        else
            return false;
    }
    bool isOfNow(const Snapshot &snapshot) const
    {
        if constexpr (requires { m_session.isOfNow(snapshot); })
            return m_session.isOfNow(snapshot);
        else
            return true;
    }

    // Before what else came with them. Not those of events that are told only now.
    void showValues()
    {
        if (m_state != BusState::open)
            return;
        m_runner->takeShown(m_shown);
        if (m_shown.dropped > 0)
            Q_EMIT m_session.valuesDropped(m_shown.dropped);
        const auto &byDevice = m_round.sort(m_shown.shown, m_shown.dropped == 0);
        for (std::size_t device = 0; device < byDevice.size() && m_runner; ++device)
            if (EncoderSession *encoder = byDevice[device].empty() ? nullptr : m_session.showing(device))
                Q_EMIT encoder->shown(byDevice[device]);
    }

    void tell(const Event &event)
    {
        const auto *opened = std::get_if<LinkOpened>(&event.what);
        if (opened == nullptr)
            m_session.dispatch(event);
        else if (m_state == BusState::opening) // and not closed meanwhile
            takeOpened(opened->result);
    }
    void takeOpened(const Result<void> &opened)
    {
        if (opened) {
            m_state = BusState::open;
            m_session.linkOpened();
            return;
        }
        m_thread.reset();
        m_runner.reset();
        m_state = BusState::closed;
        m_session.linkRefused(opened.error());
    }

    Session &m_session;
    std::unique_ptr<Runner> m_runner;    // null: closed
    std::unique_ptr<BusThread> m_thread; // null: by hand
    BusState m_state = BusState::closed;
    unsigned m_opened = 0; // how often
    std::shared_ptr<const Snapshot> m_latest = std::make_shared<Snapshot>();
    bool m_latestIsNew = false;
    std::deque<Event> m_events;
    bool m_isPumping = false;
    typename Runner::Mail::Shown m_shown;
    ValueRound m_round;
};

} // namespace codewheel
