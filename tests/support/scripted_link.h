// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/process_data_link.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace codewheel {

// A link for tests: a peer with any number of K3 that records their OUT words, answers as scripted, fails on
// request, and blocks until it is released or interrupted.
class ScriptedLink : public ProcessDataLink
{
public:
    // IN of a device, from its OUT; by default that of an encoder standing at 0.
    using Answer = std::function<Word(std::size_t device, Word out)>;

    explicit ScriptedLink(std::size_t devices)
        : ScriptedLink(ringOf(devices))
    {}
    explicit ScriptedLink(RingStructure structure)
        : m_structure(std::move(structure))
        , m_peerOut(m_structure.size())
    {}

    static RingStructure ringOf(std::size_t devices)
    {
        RingStructure structure;
        for (std::size_t i = 0; i < devices; ++i)
            structure.push_back({DeviceNumber{static_cast<int>(i) + 1, 0}.node(), 0x0237, 2, 2, {}});
        return structure;
    }

    void answerWith(Answer answer) { m_answer = std::move(answer); }
    void setPeerOut(std::vector<Word> out) { m_peerOut = std::move(out); }
    const std::vector<Word> &peerOut() const { return m_peerOut; }
    int exchanges() const { return m_exchanges; }
    // Makes the n-th exchange from now on fail; 1 is the next.
    void failAt(int n) { m_failAt = m_exchanges + n; }

    // From now on each exchange takes this long.
    void delay(std::chrono::milliseconds time) { m_delay = time; }

    // From now on each exchange blocks until interrupt(), or until unblock().
    void block()
    {
        const std::scoped_lock lock(m_mutex);
        m_blocks = true;
    }
    void unblock()
    {
        const std::scoped_lock lock(m_mutex);
        m_blocks = false;
        m_wake.notify_all();
    }
    void waitUntilBlocked()
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait(lock, [this] { return m_waiting; });
    }

    Result<RingStructure> open() override
    {
        ++m_tries;
        if (m_isLost)
            return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("no answer")});
        m_open = true;
        return m_structure;
    }
    // The peer disappears and returns: with the same ring, or another.
    void lose() { m_isLost = true; }
    void comeBack() { m_isLost = false; }
    void comeBackAs(RingStructure structure)
    {
        m_structure = std::move(structure);
        m_peerOut.assign(m_structure.size(), 0);
        comeBack();
    }
    int tries() const { return m_tries; } // of opening
    bool isOpen() const { return m_open; }
    void close() override { m_open = false; }
    Result<std::vector<Word>> readBackOut() override
    {
        if (!m_open)
            return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("not connected")});
        return m_peerOut;
    }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        if (!waitWhileBlocked())
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        if (!m_open || out.size() != m_peerOut.size() || in.size() != m_peerOut.size())
            return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("not connected")});
        if (m_isLost || ++m_exchanges == m_failAt)
            return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("cable pulled")});
        m_peerOut.assign(out.begin(), out.end());
        for (std::size_t i = 0; i < in.size(); ++i)
            in[i] = m_answer ? m_answer(i, out[i]) : 0;
        return {};
    }
    Instant now() const override { return m_now; }
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    bool boundsWordsToCycles() const override { return m_boundsWordsToCycles; }
    void repeatWordsByItself() { m_boundsWordsToCycles = false; }
    void interrupt() override
    {
        const std::scoped_lock lock(m_mutex);
        m_interrupted = true;
        m_wake.notify_all();
    }

private:
    bool waitWhileBlocked()
    {
        std::unique_lock lock(m_mutex);
        if (m_delay > std::chrono::milliseconds(0))
            m_wake.wait_for(lock, m_delay, [this] { return m_interrupted; });
        if (m_blocks) {
            m_waiting = true;
            m_wake.notify_all();
            m_wake.wait(lock, [this] { return !m_blocks || m_interrupted; });
            m_waiting = false;
        }
        return !std::exchange(m_interrupted, false);
    }

    RingStructure m_structure;
    Answer m_answer;
    std::vector<Word> m_peerOut;
    bool m_open = false;
    bool m_isLost = false;
    int m_tries = 0;
    bool m_boundsWordsToCycles = true;
    std::chrono::milliseconds m_delay{0};
    Instant m_now{};
    int m_exchanges = 0;
    int m_failAt = 0;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_blocks = false;
    bool m_waiting = false;
    bool m_interrupted = false;
};

} // namespace codewheel
