// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_thread.h"
#include "bus/pacer.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "tests/kinds/interbus/ring/word_by_word_driver.h"
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

TEST(Pacer, WhatWaitedForTheLinkIsNotLate)
{
    Pacer pacer(start, 1ms);
    pacer.cycleEnded(start + 3500us, false);
    EXPECT_EQ(pacer.lateCycles(), 0u);
    EXPECT_EQ(pacer.deadline(), start + 4ms);
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

class BusThreadTest : public testing::Test
{
protected:
    BusThreadTest()
    {
        m_runner = std::make_unique<RingRunner>(m_link);
        EXPECT_TRUE(m_runner->open({}));
        command::UseRing ring{ScriptedLink::ringOf(1), {0}, {}};
        ring.drivers.push_back({std::make_unique<WordByWordDriver>(), {}});
        m_runner->post(std::move(ring));
        m_runner->post(command::StartBus{});
        m_runner->post(command::SetOperate{true});
    }
    // The first outcome to arrive; limited by the time-out of the whole test program.
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

TEST_F(BusThreadTest, CyclesTheRunnerWhileTheWindowPostsAndTakes)
{
    const BusThread thread(*m_runner, {.period = 1ms}, true);
    for (JobId job = 1; job <= 20; ++job) {
        m_runner->post(command::StartJob{0, job, SendWords{{0x020000FF, 0x80000000}}, Pace::byItself});
        const Outcome outcome = waitForOutcome();
        EXPECT_EQ(outcome.job, job);
        EXPECT_TRUE(outcome.result);
        std::shared_ptr<const Snapshot> snapshot;
        while (!(snapshot = m_runner->takeLatest())) // limited like the outcome
            std::this_thread::yield();
        EXPECT_EQ(snapshot->period, 1ms);
    }
}

TEST_F(BusThreadTest, TheLinksClockGoesWithTheCycles)
{
    const BusThread thread(*m_runner, {.period = 1ms}, true);
    Instant last{};
    for (int i = 0; i < 20; ++i) {
        std::shared_ptr<const Snapshot> snapshot;
        while (!(snapshot = m_runner->takeLatest()))
            std::this_thread::yield();
        EXPECT_EQ(snapshot->at % 1ms, Instant(0));
        EXPECT_GE(snapshot->at, last);
        last = snapshot->at;
    }
    EXPECT_GT(last, 0ms);
}

TEST_F(BusThreadTest, StopInterruptsALinkThatBlocks)
{
    m_link.block();
    {
        const BusThread thread(*m_runner, {.period = 1ms}, true);
        m_link.waitUntilBlocked();
    }
    EXPECT_FALSE(m_link.isOpen());
    EXPECT_EQ(m_link.exchanges(), 0);
    for (const RingEvent &event : m_runner->takeEvents()) {
        const auto *message = std::get_if<Message>(&event.what);
        EXPECT_FALSE(message && message->refusal) << "our own interrupt is no failure of the link";
    }
}

TEST_F(BusThreadTest, StopsPromptlyWhateverThePeriod)
{
    {
        const BusThread thread(*m_runner, {.period = 24h}, true);
        while (!m_runner->takeLatest())
            std::this_thread::yield();
    }
    EXPECT_EQ(m_link.exchanges(), 1);
}

} // namespace
} // namespace codewheel
