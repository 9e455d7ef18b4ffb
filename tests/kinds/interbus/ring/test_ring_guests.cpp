// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/master_status.h"
#include "kinds/interbus/ring/ring_guests.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "tests/kinds/interbus/ring/word_by_word_driver.h"
#include "tests/support/scripted_link.h"

#include <atomic>
#include <future>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

constexpr auto patience = 60'000ms;

RefusalCode refusalOf(const Result<GuestSent> &result)
{
    return result ? RefusalId::nothingToDo : result.error().id;
}

// A ring that is offered, driven by hand; what its devices got, cycle by cycle.
class RingGuestsTest : public testing::Test
{
protected:
    void SetUp() override { offer(3); }
    void offer(std::size_t devices)
    {
        m_link = std::make_unique<ScriptedLink>(devices);
        m_link->answerWith([this](std::size_t device, Word out) {
            m_got[device].push_back(out);
            return out + 0x100;
        });
        m_runner = std::make_unique<RingRunner>(*m_link);
        EXPECT_TRUE(m_runner->open({}));
        m_runner->post(command::OfferTo{m_guests});
        useRing(devices);
        m_runner->post(command::StartBus{});
        m_runner->post(command::SetOperate{true});
        cycle();
    }
    void useRing(std::size_t devices)
    {
        command::UseRing ring{ScriptedLink::ringOf(devices), m_link->peerOut(), {}};
        for (std::size_t i = 0; i < devices; ++i)
            ring.drivers.push_back({std::make_unique<WordByWordDriver>(), {}});
        m_runner->post(std::move(ring));
    }
    void cycle() { m_runner->cycle(m_now += 1ms); }
    // As a guest in a thread of its own, while cycles pass.
    Result<GuestSent> write(std::vector<GuestWord> words)
    {
        auto sent = std::async(std::launch::async, [&] {
            return m_guests->write(m_guests->image(patience), std::move(words), patience);
        });
        while (sent.wait_for(0ms) != std::future_status::ready)
            cycle();
        return sent.get();
    }
    int guestWrote()
    {
        int count = 0;
        for (const RingEvent &event : m_runner->takeEvents())
            count += std::holds_alternative<GuestWrote>(event.what) ? 1 : 0;
        return count;
    }

    std::map<std::size_t, std::vector<Word>> m_got;
    std::shared_ptr<RingGuests> m_guests = std::make_shared<RingGuests>();
    std::unique_ptr<ScriptedLink> m_link;
    std::unique_ptr<RingRunner> m_runner;
    Instant m_now{};
};

TEST_F(RingGuestsTest, AWriteEndsOnceItWasOnTheBus)
{
    const auto sent = write({{1, 0x12345678}});
    ASSERT_TRUE(sent);
    EXPECT_THAT(sent->words, ElementsAre(0x12345678U));
    EXPECT_EQ(m_got[1].at(sent->cycle - 1), 0x12345678U);
    EXPECT_EQ(m_got[1].at(sent->cycle - 2), 0U);
    EXPECT_THAT(m_guests->image(patience).out, ElementsAre(0U, 0x12345678U, 0U));
    EXPECT_THAT(m_guests->image(patience).in, ElementsAre(0x100U, 0x12345778U, 0x100U));
    EXPECT_EQ(m_guests->image(patience).status, 0x00E0) << "healthy in RUN";
}

TEST_F(RingGuestsTest, OfAWordOnlyTheBitsInTheMaskAreChanged)
{
    ASSERT_TRUE(write({{0, 0x11112222}}));
    const auto sent = write({{0, 0xABCDABCD, 0x0000FFFF}});
    ASSERT_TRUE(sent);
    EXPECT_THAT(sent->words, ElementsAre(0x1111ABCDU));
    EXPECT_THAT(sent->before, ElementsAre(0x11112222U));
    EXPECT_EQ(m_got[0].back(), 0x1111ABCDU);
}

TEST_F(RingGuestsTest, TheWordsOfOneWriteGoOutInOneCycle)
{
    const auto sent = write({{0, 1}, {1, 2}, {2, 3}});
    ASSERT_TRUE(sent);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(m_got[i].at(sent->cycle - 1), i + 1);
        EXPECT_EQ(m_got[i].at(sent->cycle - 2), 0U);
    }
}

// Several guests at one device, others at several: none is lost, none is written over, all in one cycle.
TEST_F(RingGuestsTest, EachWriteIsOnTheBusForACycleOfItsOwn)
{
    constexpr Word writes = 300;
    std::atomic<int> left = 3;
    const auto guest = [&](Word mark, std::vector<std::size_t> devices) {
        std::vector<std::uint64_t> cycles;
        for (Word i = 1; i <= writes; ++i) {
            std::vector<GuestWord> words;
            for (const std::size_t device : devices)
                words.push_back({device, mark + i});
            const auto sent = m_guests->write(m_guests->image(patience), words, patience);
            cycles.push_back(sent ? sent->cycle : 0);
        }
        --left;
        return cycles;
    };
    auto first = std::async(std::launch::async, guest, 0x1000, std::vector<std::size_t>{0});
    auto second = std::async(std::launch::async, guest, 0x2000, std::vector<std::size_t>{0, 2});
    auto third = std::async(std::launch::async, guest, 0x3000, std::vector<std::size_t>{2, 1});
    while (left > 0)
        cycle();
    const auto isThere = [&](const std::vector<std::uint64_t> &cycles, Word mark, std::size_t device) {
        for (Word i = 1; i <= writes; ++i)
            ASSERT_EQ(m_got[device].at(cycles[i - 1] - 1), mark + i);
    };
    const auto firstCycles = first.get();
    const auto secondCycles = second.get();
    const auto thirdCycles = third.get();
    isThere(firstCycles, 0x1000, 0);
    isThere(secondCycles, 0x2000, 0);
    isThere(secondCycles, 0x2000, 2);
    isThere(thirdCycles, 0x3000, 2);
    isThere(thirdCycles, 0x3000, 1);
}

TEST_F(RingGuestsTest, NothingIsWrittenInWatchOrWhileTheBusIsStopped)
{
    m_runner->post(command::SetOperate{false});
    EXPECT_EQ(refusalOf(write({{0, 7}})), RefusalId::watchOnly);
    m_runner->post(command::StopBus{});
    m_runner->post(command::SetOperate{true});
    EXPECT_EQ(refusalOf(write({{0, 7}})), RefusalId::notRunning);
    m_runner->post(command::StartBus{});
    cycle();
    EXPECT_THAT(m_got[0], testing::Each(0U)) << "nor later";
}

TEST_F(RingGuestsTest, AWordThatAJobHoldsIsNotWrittenNorWhatWasWrittenWithIt)
{
    m_runner->post(command::StartJob{1, 1, SendWords{std::vector<Word>(100'000, 5)}, Pace::byItself});
    EXPECT_EQ(refusalOf(write({{0, 7}, {1, 7}})), RefusalId::wordHeldByJob);
    EXPECT_TRUE(write({{0, 8}}));
    EXPECT_THAT(m_got[0], testing::Not(testing::Contains(7U)));
}

// A guest that always writes, and a user in every second cycle: each word is on the bus.
TEST_F(RingGuestsTest, WhatTheUserWritesInTheSameCycleIsNotWrittenOver)
{
    constexpr Word writes = 200;
    constexpr Word ofUser = 0x10000;
    auto guest = std::async(std::launch::async, [&] {
        Word acknowledged = 0;
        for (Word i = 1; i <= writes; ++i)
            acknowledged += m_guests->write(m_guests->image(patience), {{0, i}}, patience) ? 1 : 0;
        return acknowledged;
    });
    Word byHand = ofUser;
    while (guest.wait_for(0ms) != std::future_status::ready) {
        m_runner->post(command::SetOut{0, ++byHand});
        cycle();
        cycle();
    }
    EXPECT_EQ(guest.get(), writes);
    const std::set<Word> got(m_got[0].begin(), m_got[0].end());
    EXPECT_EQ(got.size(), 1 + writes + (byHand - ofUser));
}

TEST_F(RingGuestsTest, AfterAnAlarmStopZerosStay)
{
    ASSERT_TRUE(write({{0, 7}}));
    m_runner->post(command::AlarmStop{});
    cycle();
    EXPECT_EQ(m_got[0].back(), 0U);
}

TEST_F(RingGuestsTest, OnlyAChangedWordIsReported)
{
    guestWrote();
    ASSERT_TRUE(write({{0, 7}}));
    EXPECT_EQ(guestWrote(), 1);
    ASSERT_TRUE(write({{0, 7}}));
    EXPECT_EQ(guestWrote(), 0);
}

TEST_F(RingGuestsTest, AWordOfACycleThatFailedIsRefusedAndNotSentLater)
{
    m_link->failAt(1);
    m_link->lose();
    EXPECT_EQ(refusalOf(write({{0, 7}})), RefusalId::linkFailed) << "why the link is lost";
    EXPECT_EQ(m_guests->image(patience).status & 0x0020, 0) << "not in RUN";
    m_link->comeBack();
    m_now += 1s;
    cycle();
    m_runner->post(command::SetOperate{true});
    cycle();
    EXPECT_EQ(m_got[0].back(), 0U);
}

// Whether it waited for that exchange or came just behind it.
TEST_F(RingGuestsTest, AWordOfTheExchangeThatLosesTheLinkIsRefusedForThatReason)
{
    auto sent = std::async(std::launch::async, [&] {
        return m_guests->write(m_guests->image(patience), {{0, 7}}, patience);
    });
    std::this_thread::sleep_for(20ms); // it waits by now, mostly
    m_link->failAt(1);
    m_link->lose();
    while (sent.wait_for(0ms) != std::future_status::ready)
        cycle();
    EXPECT_EQ(refusalOf(sent.get()), RefusalId::linkFailed);
}

TEST_F(RingGuestsTest, AWordOfACycleThatWasSkippedIsRefusedAndNotSentLater)
{
    auto sent = std::async(std::launch::async, [&] {
        return m_guests->write(m_guests->image(patience), {{0, 7}}, patience);
    });
    while (sent.wait_for(0ms) != std::future_status::ready) {
        m_link->interrupt();
        cycle();
    }
    EXPECT_EQ(refusalOf(sent.get()), RefusalId::notRunning);
    cycle();
    EXPECT_THAT(m_got[0], testing::Each(0U));
}

TEST_F(RingGuestsTest, AWriteForTheRingOfBeforeIsRefused)
{
    const GuestImage before = m_guests->image(patience);
    useRing(3);
    cycle();
    EXPECT_EQ(refusalOf(m_guests->write(before, {{0, 7}}, patience)), RingRefusalId::notInRing);
}

// Whoever watches it asks then whether the encoders are the same.
TEST_F(RingGuestsTest, AnotherRingSeemsToStandAtFirst)
{
    const auto runs = [this] { return (m_guests->image(patience).status & diagnostic::run) != 0; };
    EXPECT_TRUE(runs());
    useRing(3);
    cycle();
    EXPECT_FALSE(runs());
    m_now += RingGuests::anotherStandsFor - 10ms;
    cycle();
    EXPECT_FALSE(runs());
    m_now += 10ms;
    cycle();
    EXPECT_TRUE(runs());
    EXPECT_TRUE(write({{0, 7}}));
}

TEST_F(RingGuestsTest, WithoutCyclesAWriteIsGivenUpAndNotSentLater)
{
    EXPECT_EQ(refusalOf(m_guests->write(m_guests->image(patience), {{0, 7}}, 1ms)), RefusalId::busStopped);
    cycle();
    EXPECT_THAT(m_got[0], testing::Each(0U));
}

TEST_F(RingGuestsTest, WhenTheBusIsClosedGuestsHaveNoRing)
{
    auto sent = std::async(std::launch::async, [&] {
        Result<GuestSent> last = GuestSent{};
        while (last) // until it is refused
            last = m_guests->write(m_guests->image(patience), {{0, 7}}, patience);
        return last;
    });
    for (int i = 0; i < 10; ++i)
        cycle();
    m_runner->close();
    EXPECT_THAT(refusalOf(sent.get()),
                testing::AnyOf(RefusalId::busStopped, RingRefusalId::notInRing, RefusalId::notRunning));
    EXPECT_FALSE(m_guests->image(patience).ring);
}

TEST_F(RingGuestsTest, WhoComesBeforeTheFirstCycleWaitsForIt)
{
    const auto early = std::make_shared<RingGuests>();
    auto image = std::async(std::launch::async, [&] { return early->image(patience); });
    EXPECT_FALSE(early->image(1ms).ring);
    m_runner->post(command::OfferTo{early});
    cycle();
    EXPECT_TRUE(image.get().ring);
}

TEST_F(RingGuestsTest, ARingThatWasNotReadInLetsNobodyWait)
{
    RingRunner runner(*m_link);
    const auto guests = std::make_shared<RingGuests>();
    runner.post(command::OfferTo{guests});
    runner.cycle(m_now);
    EXPECT_FALSE(guests->image(patience).ring);
}

TEST_F(RingGuestsTest, OfferedToOthersTheFirstHaveNoRing)
{
    const auto others = std::make_shared<RingGuests>();
    m_runner->post(command::OfferTo{others});
    cycle();
    EXPECT_FALSE(m_guests->image(patience).ring);
    ASSERT_TRUE(others->image(patience).ring);
    EXPECT_EQ(others->image(patience).ring->size(), 3U);
}

} // namespace
} // namespace codewheel
