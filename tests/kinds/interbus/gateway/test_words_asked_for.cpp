// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever happens on the way to a gateway: nothing is sent that nobody asked for, and what we have sent
// ourselves is not taken for somebody else's.
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/kinds/interbus/gateway/watched_registers.h"

#include <array>
#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr int devicesOfWords = 3;
constexpr Word askedWord = 0x0200'00FF;
constexpr Word plcWord = 0x0400'0001;

class WordsAskedFor : public testing::Test
{
protected:
    void open(const GatewaySettings &settings = {}, unsigned seed = 1)
    {
        link = std::make_unique<GatewayLink>(std::make_unique<WatchedRegisters>(bank, trouble, seed),
                                             settings, k3Ring(devicesOfWords));
        runner = std::make_unique<RingRunner>(*link);
        ASSERT_TRUE(runner->open({}));
    }
    void useRing()
    {
        command::UseRing ring{structureOf(k3Ring(devicesOfWords)), std::vector<Word>(devicesOfWords), {}};
        ring.drivers.resize(devicesOfWords);
        runner->post(std::move(ring));
    }
    void operate(const GatewaySettings &settings = {}, unsigned seed = 1)
    {
        open(settings, seed);
        useRing();
        post(command::StartBus{}, 100ms);
        post(command::SetOperate{true}, 100ms);
    }
    void post(Command command, Instant duration = {})
    {
        runner->post(std::move(command));
        advance(duration);
    }
    void advance(Instant duration)
    {
        for (const Instant end = runner->now() + duration; runner->now() < end; turned())
            runner->turn(std::min(end, runner->now() + 10ms));
    }
    void turned()
    {
        for (RingEvent &event : runner->takeEvents())
            events.push_back(std::move(event));
        if (auto newest = runner->takeLatest())
            latest = *newest;
    }
    void loseLink()
    {
        trouble.isAway = true;
        advance(100ms);
        ASSERT_FALSE(latest.connected);
    }
    void giveLinkBack()
    {
        trouble.isAway = false;
        advance(2s);
        ASSERT_TRUE(latest.connected);
    }

    Word outOf(int device) { return word(bank->holding[2 * device], bank->holding[2 * device + 1]); }
    static Word word(Register high, Register low) { return Word{high} << 16 | low; }
    void setOut(int device, Word word)
    {
        bank->holding[2 * device] = static_cast<Register>(word >> 16);
        bank->holding[2 * device + 1] = static_cast<Register>(word);
    }
    std::size_t countOf(RefusalCode id) const
    {
        return count([id](const Message &message) { return message.refusal && message.refusal->id == id; });
    }
    std::size_t countOf(MessageCode id) const
    {
        return count([id](const Message &message) { return message.id == id; });
    }
    template <typename Condition>
    std::size_t count(Condition isMeant) const
    {
        return static_cast<std::size_t>(std::ranges::count_if(events, [&](const RingEvent &event) {
            const auto *message = std::get_if<Message>(&event.what);
            return message != nullptr && isMeant(*message);
        }));
    }

    std::shared_ptr<RegisterBank> bank = std::make_shared<RegisterBank>();
    GatewayTrouble trouble;
    std::unique_ptr<GatewayLink> link;
    std::unique_ptr<RingRunner> runner;
    std::vector<RingEvent> events;
    Snapshot latest;
};

// 0, the word, 0 again: all within the time until the first of them is shown.
TEST_F(WordsAskedFor, WhatTheGatewayShowsLateIsOursHoweverFastItWasReplaced)
{
    trouble.lag = 300ms;
    operate();
    post(command::SetOut{0, askedWord}, 30ms);
    post(command::SetOut{0, 0}, 2s);
    EXPECT_EQ(countOf(GatewayRefusalId::outNotOurs), 0u);
    EXPECT_TRUE(latest.operate);
    EXPECT_EQ(outOf(0), 0u);
}

TEST_F(WordsAskedFor, AMomentInWatchDoesNotBringBackWhatWasReplaced)
{
    trouble.lag = 700ms;
    operate();
    post(command::SetOut{0, askedWord}, 50ms);
    post(command::SetOperate{false}, 100ms);
    EXPECT_EQ(latest.devices[0].out, askedWord);
    post(command::SetOperate{true}, 2s);
    EXPECT_EQ(outOf(0), askedWord);
    EXPECT_EQ(countOf(GatewayRefusalId::outNotOurs), 0u);
    EXPECT_TRUE(latest.operate);
}

// The gateway still shows the word of before the stop when it is connected again.
TEST_F(WordsAskedFor, AQuickReconnectionDoesNotBringBackWhatWasStopped)
{
    operate();
    post(command::SetOut{0, askedWord}, 2s);
    trouble.lag = 700ms;
    post(command::AlarmStop{}, 50ms);
    trouble.isAway = true;
    advance(50ms);
    ASSERT_FALSE(latest.connected);
    trouble.isAway = false;
    post(command::StartBus{}, 2s); // tries at once
    ASSERT_TRUE(latest.connected);
    EXPECT_EQ(latest.devices[0].out, 0u);
    post(command::SetOperate{true}, 2s);
    EXPECT_EQ(outOf(0), 0u);
    EXPECT_EQ(countOf(GatewayRefusalId::outNotOurs), 0u);
}

TEST_F(WordsAskedFor, OutOfAnEncoderWhoseWordIsInDoubtIsKnownAllTheSame)
{
    operate();
    post(command::SetOut{0, askedWord}, 100ms);
    post(command::SetOperate{false}, 100ms);
    trouble.isRestless = true;
    advance(500ms);
    ASSERT_FALSE(latest.devices[0].inRing);
    setOut(0, plcWord);
    advance(500ms);
    EXPECT_EQ(latest.devices[0].out, plcWord);
    post(command::StopBus{});
    post(command::StartBus{});
    post(command::SetOperate{true}, 500ms);
    EXPECT_EQ(outOf(0), plcWord);
}

TEST_F(WordsAskedFor, WhatWasNotSentBeforeWatchIsNotSentAfterIt)
{
    operate();
    post(command::SetOut{0, askedWord});
    post(command::SetOperate{false}, 5ms);
    EXPECT_EQ(countOf(MessageId::wordWritten), 0u);
    EXPECT_EQ(countOf(RefusalId::watchOnly), 1u);
    EXPECT_EQ(latest.devices[0].out, 0u);
    post(command::SetOperate{true}, 500ms);
    EXPECT_EQ(outOf(0), 0u);
}

TEST_F(WordsAskedFor, ARingThatWasStoppedStaysSoWhenItsLinkIsLostByAnAlarmStop)
{
    operate();
    post(command::SetOut{0, askedWord}, 100ms);
    post(command::StopBus{}, 100ms);
    trouble.isAway = true;
    post(command::AlarmStop{}, 100ms);
    EXPECT_FALSE(latest.connected);
    EXPECT_EQ(countOf(RingMessageId::zerosWait), 1u);
    giveLinkBack();
    EXPECT_EQ(outOf(0), 0u);
    EXPECT_EQ(countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_NE(latest.state, MasterState::run);
}

TEST_F(WordsAskedFor, AnAlarmStopBeforeTheRingIsInUseGoesOutOnceItIs)
{
    setOut(1, plcWord);
    open();
    post(command::AlarmStop{}, 100ms);
    EXPECT_TRUE(latest.connected) << "the link has not failed";
    useRing();
    advance(100ms);
    EXPECT_EQ(outOf(1), 0u);
    EXPECT_EQ(countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_EQ(countOf(RingMessageId::linkBack), 0u);
}

// Its answer may have been a late one, to a write of before.
TEST_F(WordsAskedFor, ZerosThatWereAcknowledgedAndDidNotArriveAreSentAgain)
{
    operate();
    post(command::SetOut{0, askedWord}, 100ms);
    trouble.writesToDrop = 1;
    post(command::AlarmStop{}, 3s);
    EXPECT_EQ(outOf(0), 0u);
    EXPECT_EQ(countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_EQ(countOf(RingMessageId::zerosOverwritten), 0u);
}

// Somebody operates the ring, a PLC writes too, and the way to the gateway fails in all ways. Each word that
// is written must be one that is there already, or that was asked for and not given up since.
class AnythingAtAll : public WordsAskedFor, public testing::WithParamInterface<unsigned>
{
protected:
    void live()
    {
        m_random.seed(GetParam());
        m_isLate = GetParam() % 2 == 1;
        if (m_isLate) // what a PLC writes is then not seen in time
            trouble.lag = pick(1, 700) * 1ms;
        operate({.pollInterval = pick(5, 60) * 1ms}, GetParam());
        m_mayWrite = true;
        trouble.opened = [this] { giveUp(); };
        trouble.writing = [this](int first, std::span<const Register> from) { look(first, from); };
        while (runner->now() < 10min && !HasFailure()) {
            for (int commands = pick(1, 3); commands > 0; --commands)
                act();
            for (int turns = pick(1, 60); turns > 0 && !HasFailure(); --turns)
                turnOnce();
        }
    }
    int written() const { return m_written; }

private:
    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(m_random); }
    void turnOnce()
    {
        events.clear();
        runner->turn(runner->now() + 10ms);
        turned();
        const bool isForeign = countOf(GatewayRefusalId::outNotOurs) > 0;
        EXPECT_FALSE(isForeign && m_isLate) << "there is nobody else";
        if (isForeign)
            giveUp();
        m_alarmStops -= countOf(RingMessageId::zerosAsked);
        if (m_alarmStops == 0 &&
            countOf(RingMessageId::zerosReadBack) + countOf(RingMessageId::zerosOverwritten) > 0)
            m_zerosAreDue = false;
    }
    void giveUp()
    {
        for (auto &words : m_asked)
            words.clear();
    }
    void act()
    {
        const int device = pick(0, devicesOfWords - 1);
        switch (pick(0, 9)) {
        case 0:
            operateOrNot(false);
            break;
        case 1:
        case 2:
            runner->post(command::StartBus{});
            operateOrNot(true);
            break;
        case 3:
            giveUp();
            runner->post(command::StopBus{});
            break;
        case 4:
            giveUp();
            m_zerosAreDue = true;
            ++m_alarmStops;
            runner->post(command::AlarmStop{});
            break;
        case 5:
            if (!m_isLate) {
                setOut(device, ++m_lastWord);
                m_asked.at(static_cast<std::size_t>(device)).clear();
            }
            break;
        case 6:
            trouble.noAnswers = pick(0, 2) * 0.02;
            trouble.exceptions = pick(0, 2) * 0.02;
            trouble.closed = pick(0, 2) * 0.003;
            trouble.isRestless = pick(0, 3) == 0;
            break;
        default:
            runner->post(command::SetOut{static_cast<std::size_t>(device), ++m_lastWord});
            m_asked.at(static_cast<std::size_t>(device)).insert(m_lastWord);
        }
    }
    void operateOrNot(bool on)
    {
        if (!on)
            giveUp();
        m_mayWrite = on;
        runner->post(command::SetOperate{on});
    }
    void look(int first, std::span<const Register> from)
    {
        const bool isBlock = from.size() == 2 * m_asked.size();
        ASSERT_TRUE((isBlock && first == 0) || (m_zerosAreDue && from.size() == 2)); // zeros, by device
        EXPECT_TRUE(m_mayWrite || m_zerosAreDue);
        for (std::size_t at = 0; at < from.size(); at += 2) {
            const int i = (first + static_cast<int>(at)) / 2;
            const Word sent = word(from[at], from[at + 1]);
            m_written += sent != outOf(i) ? 1 : 0;
            EXPECT_TRUE(sent == outOf(i) || (sent == 0 && m_zerosAreDue) ||
                        m_asked.at(static_cast<std::size_t>(i)).contains(sent))
                << "device " << i << ": " << std::hex << sent << " over " << outOf(i) << " at " << std::dec
                << runner->now().count();
        }
    }

    std::mt19937 m_random;
    bool m_isLate = false;
    bool m_mayWrite = false;
    bool m_zerosAreDue = false;
    std::size_t m_alarmStops = 0;  // on their way
    Word m_lastWord = 0x0200'0000; // each is another one
    std::array<std::set<Word>, devicesOfWords> m_asked;
    int m_written = 0;
};

TEST_P(AnythingAtAll, SendsNothingThatWasNotAskedFor)
{
    live();
    EXPECT_GT(written(), 100);
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnythingAtAll, testing::Range(1u, 25u));

} // namespace
} // namespace codewheel
