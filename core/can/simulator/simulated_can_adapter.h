// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/simulator/can_participant.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>

namespace codewheel {

// The adapter of a SimulatedCanLink on the bus: its controller, the frames that wait in it, and what there is
// to be received. What is not about waking is guarded by the bus's lock.
class SimulatedCanAdapter final : public CanParticipant
{
public:
    static constexpr std::size_t queueLength = 16; // frames that wait to be sent
    static constexpr std::size_t newsLength = 4'096;

    // `begin`: the time of the bus at which the link's clock was 0.
    SimulatedCanAdapter(int rate, Instant begin)
        : m_rate(rate)
        , m_begin(begin)
    {}

    void open(CanUse use);
    void close();
    // False: the queue is full.
    bool queue(const CanFrame &frame);
    bool hasNews() const { return !m_news.frames.empty() || !m_news.fates.empty(); }
    CanNews takeNews() { return std::exchange(m_news, {}); }
    bool listensOnly() const { return m_use == CanUse::watch; }

    // Any thread, without the bus's lock.
    void setUnplugged(bool unplugged);
    bool isUnplugged() const { return m_unplugged; }
    void wake();
    bool takeWake(); // whether wake() was called since the last time
    // Really waits until there is something to look at: what wake() tells, news, an adapter unplugged.
    void waitFor(Instant atMost);

    bool isOn() const override { return m_open && !m_unplugged; }
    int rate() const override { return m_rate; }
    bool acknowledges() const override { return m_use == CanUse::operate; }
    bool comesBack() const override { return false; }
    const CanFrame *toSend() const override { return m_queue.empty() ? nullptr : &m_queue.front(); }
    void sent(const CanFrame &frame, Instant now) override;
    void take(const CanFrame &frame, Instant now) override { tell(frame, now); }
    void disturbed(CanDisturbance how, Instant now) override;
    void stateChanged(CanState state, Instant now) override;

private:
    void tell(CanFrame frame, Instant now);
    void look();

    const int m_rate;
    const Instant m_begin;
    bool m_open = false;
    CanUse m_use = CanUse::watch;
    CanState m_state = CanState::active;
    std::deque<CanFrame> m_queue;
    CanNews m_news;

    std::atomic<bool> m_unplugged = false;
    std::mutex m_waking;
    std::condition_variable m_woken;
    bool m_wake = false;
    bool m_look = false;
};

} // namespace codewheel
