// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/faulty_register_port.h"
#include "tests/support/simulated_gateway.h"

#include <gtest/gtest.h>

namespace codewheel::test {

// A link that lets everything through, and looks at what comes of it on the gateway: nothing is written but
// what the runner gives, and no word is believed that the encoder did not have.
class CheckedLink final : public ProcessDataLink
{
public:
    // What the test allows and sees.
    struct Rules
    {
        bool mayWrite = false;    // Operate, or asked for
        bool zerosAreDue = false; // of an ALARM STOP
        Instant oldest{};         // a word that is believed
        int exchanges = 0;
        int wordsBelieved = 0;
    };

    CheckedLink(std::unique_ptr<ProcessDataLink> link, FaultyRegisterPort::Watch &watch, Rules &rules)
        : m_link(std::move(link))
        , m_rules(rules)
    {
        watch.opened = [this] { m_isReadBack = false; };
        watch.writing = [this] { lookBeforeWrite(); };
    }
    // Before it is opened.
    void lookAt(std::shared_ptr<SimulatedGateway> gateway)
    {
        m_gateway = std::move(gateway);
        m_gateway->written = [this] { lookAfterWrite(); };
    }

    Result<RingStructure> open() override { return m_link->open(); }
    void close() override { m_link->close(); }
    Result<std::vector<Word>> readBackOut() override
    {
        auto words = m_link->readBackOut();
        EXPECT_TRUE(words || words.error().id != RefusalId::outNotReadBack);
        m_isReadBack = words.has_value();
        return words;
    }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        EXPECT_TRUE(m_rules.mayWrite) << "in Watch";
        m_asked.assign(out.begin(), out.end());
        auto done = m_link->exchange(out, in);
        m_asked.clear();
        look(done.has_value(), in);
        return done;
    }
    Result<void> watch(std::span<Word> out, std::span<Word> in) override
    {
        auto done = m_link->watch(out, in);
        look(done.has_value(), in);
        return done;
    }
    Result<std::optional<bool>> sendZeros(std::span<Word> in) override
    {
        EXPECT_TRUE(m_rules.zerosAreDue);
        m_asked.assign(in.size(), 0);
        auto done = m_link->sendZeros(in);
        m_asked.clear();
        if (done)
            m_rules.zerosAreDue = false;
        return done;
    }
    std::optional<Instant> age(std::size_t device) const override { return m_link->age(device); }
    bool isUpToDate(std::size_t device) const override { return m_link->isUpToDate(device); }
    std::shared_ptr<const LinkFigures> figures() const override { return m_link->figures(); }
    Instant now() const override { return m_link->now(); }
    void wait(Instant until) override { m_link->wait(until); }
    bool isDue() const override { return m_link->isDue(); }
    bool boundsWordsToCycles() const override { return m_link->boundsWordsToCycles(); }
    void interrupt() override { m_link->interrupt(); }

private:
    void lookBeforeWrite()
    {
        EXPECT_TRUE(m_isReadBack) << "written before OUT was read back";
        EXPECT_FALSE(m_asked.empty()) << "nobody has asked for it";
        m_before = m_gateway->out();
    }
    void lookAfterWrite()
    {
        const std::vector<Word> &there = m_gateway->out();
        for (std::size_t i = 0; i < there.size() && i < m_asked.size(); ++i)
            EXPECT_TRUE(there[i] == m_asked[i] || there[i] == m_before[i]) << "device " << i;
    }
    void look(bool isDone, std::span<const Word> in)
    {
        ++m_rules.exchanges;
        for (std::size_t i = 0; isDone && i < in.size(); ++i) {
            const auto its = age(i);
            if (!its)
                continue;
            ++m_rules.wordsBelieved;
            const Instant read = now() - *its;
            EXPECT_TRUE(m_gateway->wasIn(i, in[i], read - m_rules.oldest))
                << "device " << i << ' ' << std::hex << in[i] << " at " << std::dec << read.count();
        }
    }

    std::unique_ptr<ProcessDataLink> m_link;
    std::shared_ptr<SimulatedGateway> m_gateway;
    Rules &m_rules;
    std::vector<Word> m_asked;
    std::vector<Word> m_before;
    bool m_isReadBack = false;
};

} // namespace codewheel::test
