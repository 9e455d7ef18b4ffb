// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/paced_thread.h"
#include "ring/pacer.h"
#include "ring/ring_runner.h"
#include "tests/ring/word_by_word_driver.h"
#include "tests/support/scripted_link.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Pacer::Time start{};

TEST(Pacer, DeadlinesStandOnAGridWhateverTheCyclesTake)
{
    Pacer pacer(start, 1ms);
    EXPECT_EQ(pacer.deadline(), start);
    pacer.cycleEnded(start + 700us);
    EXPECT_EQ(pacer.deadline(), start + 1ms);
    pacer.cycleEnded(start + 1900us);
    EXPECT_EQ(pacer.deadline(), start + 2ms);
    EXPECT_EQ(pacer.lateCycles(), 0u);
}

TEST(Pacer, LateCyclesAreCountedAndNotCaughtUp)
{
    Pacer pacer(start, 1ms);
    pacer.cycleEnded(start + 3500us); // the deadlines at 1, 2 and 3 ms passed
    EXPECT_EQ(pacer.lateCycles(), 3u);
    EXPECT_EQ(pacer.deadline(), start + 4ms);
    pacer.cycleEnded(start + 4100us);
    EXPECT_EQ(pacer.lateCycles(), 3u);
    EXPECT_EQ(pacer.deadline(), start + 5ms);
}

class PacedThreadTest : public testing::Test
{
protected:
    PacedThreadTest()
    {
        EXPECT_TRUE(m_link.open());
        RingRunner::Drivers drivers;
        drivers.push_back(std::make_unique<WordByWordDriver>());
        m_runner = std::make_unique<RingRunner>(m_link, ScriptedLink::ringOf(1), std::move(drivers),
                                                std::vector<Word>{0});
        m_runner->post(command::StartBus{});
        m_runner->post(command::SetOperate{true});
    }
    // The first outcome that comes; bounded by the time-out of the whole test program.
    Outcome waitForOutcome()
    {
        for (;;) {
            for (const RingEvent &event : m_runner->takeEvents())
                if (const auto *any = std::get_if<Event>(&event.what))
                    if (const auto *outcome = std::get_if<Outcome>(any))
                        return *outcome;
            std::this_thread::yield();
        }
    }

    ScriptedLink m_link{1};
    std::unique_ptr<RingRunner> m_runner;
};

TEST_F(PacedThreadTest, CyclesTheRunnerWhileTheWindowPostsAndTakes)
{
    const PacedThread thread(*m_runner, m_link, 1ms, Instant{0});
    for (JobId job = 1; job <= 20; ++job) {
        m_runner->post(command::StartJob{0, job, SendWords{{0x020000FF, 0x80000000}}, Pace::byItself});
        const Outcome outcome = waitForOutcome();
        EXPECT_EQ(outcome.job, job);
        EXPECT_TRUE(outcome.result);
        std::shared_ptr<const Snapshot> snapshot;
        while (!(snapshot = m_runner->takeLatest())) // bounded as the outcome is
            std::this_thread::yield();
        EXPECT_EQ(snapshot->period, 1ms);
    }
}

TEST_F(PacedThreadTest, StartsAndStopsFiftyTimesAndItsTimeGoesOn)
{
    Instant last{};
    for (JobId job = 1; job <= 50; ++job) {
        const PacedThread thread(*m_runner, m_link, 100us, last);
        m_runner->post(command::StartJob{0, job, SendWords{{0x020000FF}}, Pace::byItself});
        EXPECT_EQ(waitForOutcome().job, job);
        if (const auto snapshot = m_runner->takeLatest()) {
            EXPECT_GE(snapshot->at, last);
            last = snapshot->at;
        }
    }
}

TEST_F(PacedThreadTest, StopInterruptsALinkThatBlocks)
{
    m_link.block();
    {
        const PacedThread thread(*m_runner, m_link, 1ms, Instant{0});
        m_link.waitUntilBlocked();
    }
    EXPECT_EQ(m_runner->takeLatest()->state, MasterState::run)
        << "our own interrupt is no failure of the link";
    m_link.unblock();
    m_runner->cycle(Instant{1000});
    EXPECT_EQ(m_link.exchanges(), 1);
}

TEST_F(PacedThreadTest, StopsPromptlyWhateverThePeriod)
{
    {
        const PacedThread thread(*m_runner, m_link, 24h, Instant{0});
        while (!m_runner->takeLatest())
            std::this_thread::yield();
    }
    EXPECT_EQ(m_link.exchanges(), 1);
}

} // namespace
} // namespace codewheel
