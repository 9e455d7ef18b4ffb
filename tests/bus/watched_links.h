// SPDX-License-Identifier: GPL-3.0-or-later
// Links that pass everything on, count what could change something at the far end, and can be lost or block.
#pragma once

#include "can/can_link.h"
#include "serial/byte_link.h"
#include "tests/support/passing_link.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

namespace codewheel::test {

// What the test observes and controls of a link, whichever thread uses it.
class LinkWatch
{
public:
    std::atomic<int> changes{0}; // that went out
    std::atomic<bool> isGone{false};

    // From now on opening blocks until it is interrupted.
    void blockOpening(bool on) { m_blocks = on; }
    bool waitWhileBlocked()
    {
        std::unique_lock lock(m_mutex);
        m_wake.wait(lock, [this] { return !m_blocks || m_isInterrupted; });
        return !std::exchange(m_isInterrupted, false);
    }
    void interrupt()
    {
        const std::scoped_lock lock(m_mutex);
        m_isInterrupted = m_blocks;
        m_wake.notify_all();
    }

private:
    std::atomic<bool> m_blocks{false};
    bool m_isInterrupted = false;
    std::mutex m_mutex;
    std::condition_variable m_wake;
};

// Counts cycles in which a word other than 00000000 went out.
class WatchedRingLink final : public PassingLink
{
public:
    WatchedRingLink(std::unique_ptr<ProcessDataLink> link, LinkWatch &watch)
        : PassingLink(std::move(link))
        , m_watch(watch)
    {}

    Result<RingStructure> open() override
    {
        if (!m_watch.waitWhileBlocked())
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        return m_watch.isGone ? gone() : PassingLink::open();
    }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        if (m_watch.isGone)
            return gone();
        m_watch.changes += std::ranges::any_of(out, [](Word word) { return word != 0; }) ? 1 : 0;
        return PassingLink::exchange(out, in);
    }
    // A link that bounds words to cycles sends them in Watch too.
    Result<void> watch(std::span<Word> out, std::span<Word> in) override
    {
        if (boundsWordsToCycles())
            return exchange(out, in);
        if (m_watch.isGone)
            return gone();
        return PassingLink::watch(out, in);
    }
    Result<ZerosSent> sendZeros(std::span<Word> in) override
    {
        if (m_watch.isGone)
            return gone();
        return PassingLink::sendZeros(in);
    }
    bool sendZerosUnheard() override { return !m_watch.isGone && PassingLink::sendZerosUnheard(); }
    void interrupt() override
    {
        m_watch.interrupt();
        PassingLink::interrupt();
    }

private:
    static tl::unexpected<Refusal> gone()
    {
        return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("cable pulled")});
    }

    LinkWatch &m_watch;
};

// Counts requests with a value: ESC, address, command, eight digits, CR LF. Reads have none.
class WatchedLineLink final : public ByteLink
{
public:
    WatchedLineLink(std::unique_ptr<ByteLink> link, LinkWatch &watch)
        : m_link(std::move(link))
        , m_watch(watch)
    {}

    Result<void> open(const SerialSettings &settings) override
    {
        if (!m_watch.waitWhileBlocked())
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        return m_watch.isGone ? gone(RefusalId::portNotFound) : m_link->open(settings);
    }
    void close() override { m_link->close(); }
    Result<void> setBaudRate(int baudRate) override { return m_link->setBaudRate(baudRate); }
    Instant now() const override { return m_link->now(); }
    void wait(Instant until) override { m_link->wait(until); }
    Result<void> write(const QByteArray &bytes) override
    {
        if (m_watch.isGone)
            return gone(RefusalId::portLost);
        m_watch.changes += bytes.size() > longestQuestion ? 1 : 0;
        return m_link->write(bytes);
    }
    Result<QByteArray> read(Instant until) override
    {
        if (m_watch.isGone)
            return gone(RefusalId::portLost);
        return m_link->read(until);
    }
    QString name() const override { return m_link->name(); }
    bool isSimulated() const override { return m_link->isSimulated(); }
    void interrupt() override
    {
        m_watch.interrupt();
        m_link->interrupt();
    }

private:
    static constexpr qsizetype longestQuestion = 7;

    tl::unexpected<Refusal> gone(RefusalCode id) const
    {
        return refuse(RefusalKind::link, id, {m_link->name()});
    }

    std::unique_ptr<ByteLink> m_link;
    LinkWatch &m_watch;
};

// Counts writes by SDO, and commands of NMT.
class WatchedCanBusLink final : public CanLink
{
public:
    WatchedCanBusLink(std::unique_ptr<CanLink> link, LinkWatch &watch)
        : m_link(std::move(link))
        , m_watch(watch)
    {}

    Result<void> open(CanUse use) override
    {
        if (!m_watch.waitWhileBlocked())
            return refuse(RefusalKind::stopped, RefusalId::cancelled);
        return m_watch.isGone ? gone() : m_link->open(use);
    }
    void close() override { m_link->close(); }
    Instant now() const override { return m_link->now(); }
    void wait(Instant until) override { m_link->wait(until); }
    Result<CanNews> receive(Instant until) override
    {
        return m_watch.isGone ? Result<CanNews>(gone()) : m_link->receive(until);
    }
    Result<bool> send(const CanFrame &frame) override
    {
        if (m_watch.isGone)
            return gone();
        const bool isRead = frame.id != 0 && (frame.bytes[0] & writes) != writes;
        m_watch.changes += isRead ? 0 : 1;
        return m_link->send(frame);
    }
    CanStatus status() const override { return m_link->status(); }
    QString name() const override { return m_link->name(); }
    bool isSimulated() const override { return m_link->isSimulated(); }
    void interrupt() override
    {
        m_watch.interrupt();
        m_link->interrupt();
    }

private:
    static constexpr unsigned writes = 0x20; // 40h reads

    tl::unexpected<Refusal> gone() const
    {
        return refuse(RefusalKind::link, RefusalId::portLost, {m_link->name()});
    }

    std::unique_ptr<CanLink> m_link;
    LinkWatch &m_watch;
};

} // namespace codewheel::test
