// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/process_data_link.h"

#include <condition_variable>
#include <functional>
#include <mutex>

namespace codewheel {

// A link for tests: a peer of any number of K3 that remembers its OUT words, answers what the test says,
// fails when the test says so, and blocks until it is let go or interrupted.
class ScriptedLink : public ProcessDataLink
{
public:
    // IN of a device, from its OUT; an encoder that stands at 0 if nothing else is said.
    using Answer = std::function<Word(std::size_t device, Word out)>;

    explicit ScriptedLink(std::size_t devices)
        : m_peerOut(devices)
    {}

    static RingStructure ringOf(std::size_t devices)
    {
        RingStructure structure;
        for (std::size_t i = 0; i < devices; ++i)
            structure.push_back({{static_cast<int>(i) + 1, 0}, 0x37, 0x0237, 2, 2, {}});
        return structure;
    }

    void answerWith(Answer answer) { m_answer = std::move(answer); }
    void setPeerOut(std::vector<Word> out) { m_peerOut = std::move(out); }
    const std::vector<Word> &peerOut() const { return m_peerOut; }
    int exchanges() const { return m_exchanges; }
    // The n-th exchange from now on fails, 1 being the next.
    void failAt(int n) { m_failAt = m_exchanges + n; }

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

    Result<RingStructure> open() override { return ringOf(m_peerOut.size()); }
    void close() override {}
    Result<std::vector<Word>> readBackOut() override { return m_peerOut; }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        if (!waitWhileBlocked())
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        if (++m_exchanges == m_failAt)
            return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("cable pulled")});
        m_peerOut.assign(out.begin(), out.end());
        for (std::size_t i = 0; i < in.size(); ++i)
            in[i] = m_answer ? m_answer(i, out[i]) : 0;
        return {};
    }
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
        if (!m_blocks)
            return true;
        m_waiting = true;
        m_wake.notify_all();
        m_wake.wait(lock, [this] { return !m_blocks || m_interrupted; });
        m_waiting = false;
        return !std::exchange(m_interrupted, false);
    }

    Answer m_answer;
    std::vector<Word> m_peerOut;
    int m_exchanges = 0;
    int m_failAt = 0;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_blocks = false;
    bool m_waiting = false;
    bool m_interrupted = false;
};

} // namespace codewheel
