// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_bus.h"
#include "bus/asked_command.h"
#include "bus/asked_snapshot.h"
#include "bus/bus_engine.h"
#include "vocabulary/sleep_watch.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace codewheel {

// The session of a connected bus whose encoders are asked: owns link, runner and thread, hands commands to
// the runner, and shows the encoders what comes of it. All of it lives in the caller's thread; that of the
// bus is hidden behind pump(). `Snapshot` is an AskedSnapshot; `Command` has those of asked_command.h.
template <class Command, class BusEvent, class Snapshot, class Link>
class BusSession : public AskedBus
{
public:
    using Runner = BusRunner<Command, BusEvent, Snapshot>;

    void close() override
    {
        const bool wasOpen = isOpen();
        if (!m_engine.close())
            return;
        auto closed = std::make_shared<Snapshot>(latest());
        static_cast<State &>(*closed) = {};
        m_engine.setLatest(std::move(closed));
        if (wasOpen)
            tell(closedMessage());
        showLatest();
    }
    // By hand until now, from now on by a thread.
    void startThread(SleepWatch::Slept slept = SleepWatch::ofThisComputer)
    {
        m_engine.startThread({.slept = std::move(slept)});
    }
    void advance(Instant duration) override
    {
        endRetired();
        m_engine.advance(duration, duration);
    }
    void pump() override
    {
        endRetired();
        m_engine.pump();
    }

    BusState state() const override
    {
        const bool isLost = m_engine.state() == BusState::open && !latest().connected;
        return isLost ? BusState::lost : m_engine.state();
    }
    bool isSimulated() const override { return m_link->isSimulated(); }
    QString linkName() const override { return m_link->name(); }
    const Snapshot &latest() const { return *m_engine.latest(); }
    bool isOperating() const override { return latest().operate; }
    bool isRunning() const override { return latest().connected && latest().running; }
    Instant now() const override { return latest().at; }

    void setRunning(bool on) override { post(command::SetRunning{on}); } // encoders are asked, or not
    void setOperate(bool on) override { post(command::SetOperate{on}); }
    // Ends all jobs, and drops what waits to be sent.
    void alarmStop() override { post(command::AlarmStop{}); }
    void cancelScan() { post(command::CancelScan{}); }

protected:
    BusSession(BusId id, const QDateTime &begin, const Traits &traits, std::unique_ptr<Link> link,
               const Catalog &catalog, QObject *parent)
        : AskedBus(id, begin, traits, catalog, parent)
        , m_link(std::move(link))
        , m_engine(*this)
    {}

    Link &link() const { return *m_link; }
    bool isBegun() const override { return m_engine.isBegun(); }
    void post(Command command) { m_engine.post(std::move(command)); }
    // Closed before; encoders and sessions of an earlier connection end.
    Result<void> begin(std::unique_ptr<Runner> runner, Start start, Drive drive, SleepWatch::Slept slept)
    {
        m_start = start;
        retireAll();
        std::optional<Pacing> pacing;
        if (drive == Drive::byThread)
            pacing.emplace(Pacing{.slept = std::move(slept)});
        runner->post(command::SetRunning{true});
        if (start == Start::operating)
            runner->post(command::SetOperate{true});
        return m_engine.open(std::move(runner), std::move(pacing));
    }

private:
    template <class EngineRunner, class Session>
    friend class BusEngine;
    using State = typename Snapshot::State;

    virtual Message openedMessage() const = 0;
    virtual Message closedMessage() const = 0;
    virtual void complete(State & /*opened*/) const {}
    // What is neither of a driver, nor a message, nor a sleep.
    virtual void takeOther(const BusEvent &event) = 0;

    bool isPumping() const override { return m_engine.isPumping(); }
    void postJob(JobCommand command) override
    {
        std::visit([this](auto &one) { post(std::move(one)); }, command);
    }
    void stopAsking(std::size_t device) override { post(command::RemoveDevice{device}); }
    AskedEncoder *showing(std::size_t device) const { return encoderOf(device); }

    // As it will be once the thread has carried out what was posted.
    void linkOpened()
    {
        auto expected = std::make_shared<Snapshot>();
        State &state = *expected;
        state.connected = state.running = true;
        state.operate = m_start == Start::operating;
        complete(state);
        m_engine.setLatest(std::move(expected));
        tell(openedMessage());
        showLatest();
        Q_EMIT nodesChanged();
    }

    void showLatest()
    {
        const auto shown = m_engine.latest();
        const State &state = *shown;
        tellState(std::exchange(m_told, state) != state);
        Freshness::Circumstances circumstances{.isConnected = isOpen(),
                                               .isLinkThere = shown->connected,
                                               .isRunning = shown->running,
                                               .awakeSince = shown->awakeSince,
                                               .now = shown->at};
        for (std::size_t i = 0; i < shown->devices.size(); ++i) {
            const AskedDevice &device = shown->devices[i];
            AskedEncoder *encoder = encoderOf(i);
            if (encoder == nullptr || !device.present)
                continue;
            const Place before = encoder->place();
            const Place its = placeOf(device.node);
            encoder->moveTo(its);
            circumstances.lateAfter = device.lateAfter;
            circumstances.isAnswering = device.answers;
            circumstances.whyNotAsked = device.whyNotAsked;
            encoder->show(device.reading, circumstances);
            if (its != before)
                Q_EMIT moved(before, its);
        }
    }

    void dispatch(const BusEvent &event)
    {
        if (const auto *ofDriver = std::get_if<Event>(&event.what)) {
            if (AskedEncoder *encoder = encoderOf(event.device))
                encoder->take(*ofDriver, event.at);
        } else if (const auto *message = std::get_if<Message>(&event.what)) {
            tell(*message);
        } else if (const auto *slept = std::get_if<Slept>(&event.what)) {
            takeSleep(*slept, event.at);
        } else {
            takeOther(event);
        }
    }

    std::unique_ptr<Link> m_link;
    Start m_start = Start::watching;
    State m_told;
    BusEngine<Runner, BusSession> m_engine; // destroyed before what its drivers use
};

} // namespace codewheel
