// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/process_data_link.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace codewheel {

// A kind of link that must fulfil the contract of ProcessDataLink.
struct LinkUnderTest
{
    const char *name;
    std::function<std::unique_ptr<ProcessDataLink>()> make; // closed, with at least one OUT device
    int exchangesThatFail = 0;                              // of the first four
    bool neverBlocks = false;                               // and ignores interrupt()
};

// The contract. Include in one file of a test program, and there:
// INSTANTIATE_TEST_SUITE_P(SimulatedRing, ProcessDataLinkContract, testing::Values(LinkUnderTest{...}));
class ProcessDataLinkContract : public testing::TestWithParam<LinkUnderTest>
{
protected:
    void open()
    {
        const auto structure = m_link->open();
        ASSERT_TRUE(structure);
        m_structure = *structure;
        ASSERT_FALSE(m_structure.empty());
    }
    std::vector<Word> words(Word first) const
    {
        std::vector<Word> out(m_structure.size());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = m_structure[i].outWords > 0 ? first + static_cast<Word>(i) : 0;
        return out;
    }
    // Retries failed exchanges as often as the link under test may fail.
    Result<void> exchangeOnce(const std::vector<Word> &out)
    {
        std::vector<Word> in(m_structure.size());
        for (;;) {
            auto exchanged = m_link->exchange(out, in);
            if (exchanged || exchanged.error().kind != RefusalKind::link ||
                ++m_failures > GetParam().exchangesThatFail)
                return exchanged;
        }
    }
    void exchange(const std::vector<Word> &out)
    {
        const auto exchanged = exchangeOnce(out);
        ASSERT_TRUE(exchanged) << static_cast<int>(exchanged.error().kind);
    }

    std::unique_ptr<ProcessDataLink> m_link = GetParam().make();
    RingStructure m_structure;
    int m_failures = 0;
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ProcessDataLinkContract);

inline void PrintTo(const LinkUnderTest &link, std::ostream *stream)
{
    *stream << link.name;
}

TEST_P(ProcessDataLinkContract, ParticipantsComeInRingOrderAndAgainTheSame)
{
    open();
    for (std::size_t i = 1; i < m_structure.size(); ++i)
        EXPECT_LT(m_structure[i - 1].number, m_structure[i].number);
    const RingStructure before = m_structure;
    m_link->close();
    open();
    EXPECT_EQ(m_structure, before);
}

TEST_P(ProcessDataLinkContract, OutIsReadBackAsItWasExchanged)
{
    open();
    for (const Word first : {0x02000100u, 0x80000000u, 0u}) {
        exchange(words(first));
        EXPECT_EQ(m_link->readBackOut(), words(first));
    }
}

TEST_P(ProcessDataLinkContract, OpeningWritesNothing)
{
    open();
    exchange(words(0x04000001));
    m_link->close();
    open();
    EXPECT_EQ(m_link->readBackOut(), words(0x04000001));
}

TEST_P(ProcessDataLinkContract, NothingIsExchangedUnlessOpen)
{
    open();
    exchange(words(0x02000100));
    m_link->close();
    std::vector<Word> in(m_structure.size());
    const auto exchanged = m_link->exchange(words(0x04000001), in);
    ASSERT_FALSE(exchanged);
    EXPECT_EQ(exchanged.error().kind, RefusalKind::link);
    ASSERT_FALSE(m_link->readBackOut());
    open();
    EXPECT_EQ(m_link->readBackOut(), words(0x02000100));
}

TEST_P(ProcessDataLinkContract, WordsThatDoNotMatchTheRingAreRefused)
{
    open();
    std::vector<Word> in(m_structure.size());
    std::vector<Word> tooMany(m_structure.size() + 1);
    EXPECT_FALSE(m_link->exchange(tooMany, in));
    EXPECT_FALSE(m_link->exchange(words(0), tooMany));
    EXPECT_FALSE(m_link->exchange({}, in));
    exchange(words(0x02000100));
}

TEST_P(ProcessDataLinkContract, AnExchangeThatFailsIsAFailureOfTheLinkAndTheNextOnesGoOn)
{
    open();
    for (const Word first : {0x02000100u, 0x02000200u, 0x02000300u, 0x02000400u}) {
        exchange(words(first));
        EXPECT_EQ(m_link->readBackOut(), words(first));
    }
    EXPECT_EQ(m_failures, GetParam().exchangesThatFail);
}

TEST_P(ProcessDataLinkContract, InterruptEndsOneCallAndTheLinkGoesOn)
{
    open();
    int stopped = 0;
    const auto isStopped = [&] {
        const auto exchanged = exchangeOnce(words(0));
        if (!exchanged) {
            EXPECT_EQ(exchanged.error().kind, RefusalKind::stopped);
            ++stopped;
        }
        return !exchanged;
    };
    {
        const std::jthread other([&](const std::stop_token &stop) {
            while (!stop.stop_requested() && !isStopped())
                ;
        });
        m_link->interrupt();
    }
    isStopped(); // the interruption may still be due
    EXPECT_EQ(stopped, GetParam().neverBlocks ? 0 : 1);
    exchange(words(0x02000100));
    EXPECT_EQ(m_link->readBackOut(), words(0x02000100));
}

} // namespace codewheel
