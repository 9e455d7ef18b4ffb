// SPDX-License-Identifier: GPL-3.0-or-later
// Links that hand on everything, and count what could change something at the far end.
#pragma once

#include "line/byte_link.h"
#include "ring/process_data_link.h"

#include <algorithm>
#include <memory>

namespace codewheel::test {

// Cycles in which a word that is not 00000000 went out.
class WatchedRingLink final : public ProcessDataLink
{
public:
    WatchedRingLink(std::unique_ptr<ProcessDataLink> link, int &changes)
        : m_link(std::move(link))
        , m_changes(changes)
    {}

    Result<RingStructure> open() override { return m_link->open(); }
    void close() override { m_link->close(); }
    Result<std::vector<Word>> readBackOut() override { return m_link->readBackOut(); }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        m_changes += std::ranges::any_of(out, [](Word word) { return word != 0; }) ? 1 : 0;
        return m_link->exchange(out, in);
    }
    bool boundsWordsToCycles() const override { return m_link->boundsWordsToCycles(); }
    bool isSimulated() const override { return m_link->isSimulated(); }
    void interrupt() override { m_link->interrupt(); }
    MasterLink *master() override { return m_link->master(); }

private:
    std::unique_ptr<ProcessDataLink> m_link;
    int &m_changes;
};

// Requests with a value: ESC, address, command, eight digits, CR LF. Those that only ask have none.
class WatchedLineLink final : public ByteLink
{
public:
    WatchedLineLink(std::unique_ptr<ByteLink> link, int &changes)
        : m_link(std::move(link))
        , m_changes(changes)
    {}

    Result<void> open(const LineSettings &settings) override { return m_link->open(settings); }
    void close() override { m_link->close(); }
    Result<void> setBaudRate(int baudRate) override { return m_link->setBaudRate(baudRate); }
    Instant now() const override { return m_link->now(); }
    void wait(Instant until) override { m_link->wait(until); }
    Result<void> write(const QByteArray &bytes) override
    {
        m_changes += bytes.size() > longestQuestion ? 1 : 0;
        return m_link->write(bytes);
    }
    Result<QByteArray> read(Instant until) override { return m_link->read(until); }
    QString name() const override { return m_link->name(); }
    bool isSimulated() const override { return m_link->isSimulated(); }
    void interrupt() override { m_link->interrupt(); }

private:
    static constexpr qsizetype longestQuestion = 7;

    std::unique_ptr<ByteLink> m_link;
    int &m_changes;
};

} // namespace codewheel::test
