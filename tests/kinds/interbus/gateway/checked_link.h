// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "tests/support/faulty_register_port.h"
#include "tests/support/passing_link.h"
#include "tests/support/simulated_gateway.h"

#include <gtest/gtest.h>

namespace codewheel::test {

// A link that lets everything through, and looks at what comes of it on the gateway: nothing is written but
// what the runner gives, and no word is believed that the encoder did not have.
class CheckedLink final : public PassingLink
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
        : PassingLink(std::move(link))
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

    Result<std::vector<Word>> readBackOut() override
    {
        auto words = PassingLink::readBackOut();
        EXPECT_TRUE(words || words.error().id != GatewayRefusalId::outNotReadBack);
        m_isReadBack = words.has_value();
        return words;
    }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        EXPECT_TRUE(m_rules.mayWrite) << "in Watch";
        m_asked.assign(out.begin(), out.end());
        auto done = PassingLink::exchange(out, in);
        m_asked.clear();
        look(done.has_value(), in);
        return done;
    }
    Result<void> watch(std::span<Word> out, std::span<Word> in) override
    {
        auto done = PassingLink::watch(out, in);
        look(done.has_value(), in);
        return done;
    }
    Result<ZerosSent> sendZeros(std::span<Word> in) override
    {
        EXPECT_TRUE(m_rules.zerosAreDue);
        m_asked.assign(in.size(), 0);
        auto done = PassingLink::sendZeros(in);
        m_asked.clear();
        if (done)
            m_rules.zerosAreDue = false;
        if (done && done->areThere == true) {
            EXPECT_EQ(m_gateway->out(), std::vector<Word>(in.size())) << "they have not arrived";
        }
        return done;
    }

    bool sendZerosUnheard() override
    {
        EXPECT_TRUE(m_rules.zerosAreDue);
        m_asked.assign(m_gateway->out().size(), 0);
        m_isUnheard = true;
        const bool isSent = PassingLink::sendZerosUnheard();
        m_isUnheard = false;
        m_asked.clear();
        return isSent;
    }

private:
    void lookBeforeWrite()
    {
        EXPECT_TRUE(m_isReadBack || m_isUnheard) << "written before OUT was read back";
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

    std::shared_ptr<SimulatedGateway> m_gateway;
    Rules &m_rules;
    std::vector<Word> m_asked;
    std::vector<Word> m_before;
    bool m_isReadBack = false;
    bool m_isUnheard = false; // zeros to a gateway that does not answer
};

} // namespace codewheel::test
