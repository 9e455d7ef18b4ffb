// SPDX-License-Identifier: GPL-3.0-or-later
// What is said to SLCAN adapters of several kinds, and what their answers mean, in literal bytes.
#include "can/can_refusals.h"
#include "can/slcan_conversation.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using TalkState = SlcanConversation::State;

const QString slcanPort = QStringLiteral("/dev/ttyACM0");

class SlcanTalk : public testing::Test
{
protected:
    void open(CanUse use, bool takesUnsure = false, bool isPortNew = false)
    {
        m_talk.open(use, takesUnsure, isPortNew, m_now);
    }
    // What is written now.
    std::string said() { return m_talk.next(m_now).toStdString(); }
    void hear(const QByteArray &bytes) { m_talk.received(bytes, m_now); }
    // Lets time pass; returns what is written meanwhile.
    std::string pass(Instant time)
    {
        std::string all = said();
        const Instant end = m_now + time;
        while (const auto at = m_talk.wakesAt()) {
            if (*at > end)
                break;
            m_now = std::max(*at, m_now);
            all += said();
        }
        m_now = end;
        return all + said();
    }
    void answer(const char *command, const QByteArray &bytes)
    {
        EXPECT_EQ(said(), command);
        hear(bytes);
    }
    void openLawicel(CanUse use)
    {
        open(use);
        answer("C\r", "\a");
        answer("V\r", "V1013\r");
        answer("?\r", "\a");
        answer("S5\r", "\r");
        answer(use == CanUse::watch ? "L\r" : "O\r", "\r");
        ASSERT_EQ(m_talk.state(), TalkState::open);
        answer("F\r", "F00\r");
    }
    void expectFailed(RefusalCode why)
    {
        EXPECT_EQ(m_talk.state(), TalkState::failed);
        EXPECT_EQ(m_talk.failure().id, why);
        EXPECT_EQ(said(), "C\r");
    }

    Instant m_now = 5s;
    SlcanConversation m_talk{slcanPort, 250'000};
};

using SlcanFates = std::vector<CanFate>;

const CanFrame firstFrame{.id = 0x101, .length = 0};
const CanFrame secondFrame{.id = 0x102, .length = 0};

TEST_F(SlcanTalk, ALawicelAdapterIsOpenedToListenOnly)
{
    openLawicel(CanUse::watch);
    EXPECT_TRUE(m_talk.firmware().isLawicel());
    EXPECT_EQ(m_talk.status(), (CanStatus{.state = CanState::active, .rate = 250'000, .listensOnly = true}));
    EXPECT_EQ(m_talk.close(), "C\r");
}

TEST_F(SlcanTalk, AndToSend)
{
    openLawicel(CanUse::operate);
    EXPECT_EQ(m_talk.status().listensOnly, false);
}

// UCCB answers F with another word, so it is not asked.
TEST_F(SlcanTalk, NoStateIsBelievedOfAnotherFirmware)
{
    open(CanUse::watch);
    answer("C\r", "\n");
    answer("V\r", "V1.4 UCCB\n");
    answer("?\r", "\a");
    answer("S5\r", "\n");
    answer("L\r", "\n");
    EXPECT_EQ(pass(10s), "");
    hear("F20\n");
    EXPECT_EQ(m_talk.status(), (CanStatus{.rate = 250'000, .listensOnly = true}));
    EXPECT_EQ(m_talk.skipped(), 3U);
}

TEST_F(SlcanTalk, WatchingIsNotHadOnSilentFirmware)
{
    open(CanUse::watch);
    EXPECT_EQ(said(), "C\r");
    EXPECT_EQ(pass(200ms), "V\r");
    hear("CANable-b158aa7\r");
    EXPECT_EQ(said(), "?\r");
    EXPECT_EQ(pass(199ms), "");
    EXPECT_EQ(pass(1ms), "?\r");
    EXPECT_EQ(pass(199ms), "");
    EXPECT_EQ(pass(1ms), "C\r") << "nothing was opened";
    EXPECT_EQ(m_talk.failure(), (Refusal{RefusalKind::link, CanRefusalId::watchNotSure, {slcanPort}}));
}

TEST_F(SlcanTalk, SilentFirmwareIsOpenedIfTheUserAgrees)
{
    open(CanUse::watch, true);
    EXPECT_EQ(pass(200ms), "C\rV\r");
    hear("CANable-b158aa7\r");
    EXPECT_EQ(pass(400ms), "?\r?\rS5\rO\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
    EXPECT_EQ(m_talk.status(), (CanStatus{.rate = 250'000, .listensOnly = false}));
    hear("t18528813\r");
    EXPECT_EQ(m_talk.takeNews().frames.size(), 1U);
}

TEST_F(SlcanTalk, WhatSilentFirmwareDoesIsNotKnown)
{
    open(CanUse::operate);
    EXPECT_EQ(pass(200ms), "C\rV\r");
    hear("CANable-b158aa7\r");
    EXPECT_EQ(pass(400ms), "?\r?\rS5\rO\r");
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    EXPECT_EQ(said(), "t1010\r");
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::notKnown});
}

TEST_F(SlcanTalk, ARefusedListeningIsNotOpenedInstead)
{
    for (const bool isRefused : {true, false}) {
        open(CanUse::watch);
        answer("C\r", "\r");
        answer("V\r", "V1.2\r");
        answer("?\r", "\a");
        answer("S5\r", "\r");
        EXPECT_EQ(said(), "L\r");
        if (isRefused)
            hear("\a");
        else
            pass(999ms), m_now += 1ms, m_talk.next(m_now), m_talk.next(m_now);
        EXPECT_EQ(m_talk.failure(), (Refusal{RefusalKind::link, CanRefusalId::watchNotSure, {slcanPort}}));
        EXPECT_EQ(m_talk.state(), TalkState::failed);
        said();
    }
}

TEST_F(SlcanTalk, ARefusedListeningIsOpenedIfTheUserAgrees)
{
    open(CanUse::watch, true);
    answer("C\r", "\r");
    answer("V\r", "V1.2\r");
    answer("?\r", "\a");
    answer("S5\r", "\r");
    answer("L\r", "\a");
    answer("C\r", "\a");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
    EXPECT_EQ(m_talk.status().listensOnly, false);
}

TEST_F(SlcanTalk, ABusThatWasStillOpenIsClosedOnceMore)
{
    open(CanUse::operate);
    answer("C\r", "t18528813\r\a"); // it came behind half a command
    answer("V\r", "t18528813\rV1013\r");
    answer("?\r", "\a");
    answer("S5\r", "\a");
    answer("C\r", "\r");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
    EXPECT_TRUE(m_talk.takeNews().frames.empty());
}

TEST_F(SlcanTalk, ARateThatIsRefusedOpensNothing)
{
    open(CanUse::operate);
    answer("C\r", "\r");
    answer("V\r", "V1013\r");
    answer("?\r", "\a");
    answer("S5\r", "\a");
    answer("C\r", "\r");
    answer("S5\r", "\a");
    EXPECT_EQ(m_talk.failure().arguments.back(), RefusalArgument(std::int64_t{250'000}));
    expectFailed(CanRefusalId::rateRefused);
}

TEST_F(SlcanTalk, AnOpeningWithoutAnswerIsNoOpening)
{
    open(CanUse::operate);
    answer("C\r", "\r");
    answer("V\r", "V1013\r");
    answer("?\r", "\a");
    answer("S5\r", "\r");
    EXPECT_EQ(said(), "O\r");
    EXPECT_EQ(pass(1s), "C\r");
    EXPECT_EQ(m_talk.failure().id, CanRefusalId::openingNotKnown);
}

TEST_F(SlcanTalk, APortWhereNothingAnswersIsNoAdapter)
{
    open(CanUse::operate);
    EXPECT_EQ(pass(800ms), "C\rV\r?\r?\rC\r");
    EXPECT_EQ(m_talk.failure().id, CanRefusalId::adapterSilent);
}

// Which may be what a board says when it starts.
TEST_F(SlcanTalk, NothingIsTakenForSilentWhileABoardMayStart)
{
    open(CanUse::operate, false, true);
    EXPECT_EQ(pass(200ms), "C\rV\r");
    hear("CAN BUS Shield\r\n");
    EXPECT_EQ(pass(1'799ms), "?\r?\r");
    EXPECT_EQ(pass(1ms), "C\r");
    EXPECT_EQ(m_talk.firmware().version, "");
}

// An Arduino, which starts when its port is opened and hears nothing meanwhile.
TEST_F(SlcanTalk, ABoardThatStartsIsWaitedFor)
{
    open(CanUse::operate, false, true);
    EXPECT_EQ(pass(1'999ms), "C\rV\r?\r?\r");
    EXPECT_EQ(pass(1ms), "C\r");
    answer("", "\r");
    answer("V\r", "V1.0\r");
}

TEST_F(SlcanTalk, AfterItsTextABoardIsAskedAgain)
{
    open(CanUse::operate, false, true);
    EXPECT_EQ(pass(1s), "C\rV\r?\r?\r");
    hear("CAN BUS Shield\r\n");
    EXPECT_EQ(pass(100ms), "");
    hear("init ok!\r\n");
    EXPECT_EQ(pass(199ms), "");
    EXPECT_EQ(pass(1ms), "C\r");
    hear("\r");
    answer("V\r", "V1.0\r");
    answer("?\r", "\a");
    answer("S5\r", "Setting Baudrate Successful!\r\n\r");
    answer("O\r", "Enter Normal Mode Successful!\r\n\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
}

TEST_F(SlcanTalk, WhatNeverStopsTalkingIsNoAdapter)
{
    open(CanUse::operate, false, true);
    pass(1s);
    for (int i = 0; i < 91; ++i) {
        hear("$GPGGA,hello\r\n");
        pass(100ms);
    }
    EXPECT_EQ(m_talk.failure().id, CanRefusalId::adapterSilent);
}

TEST_F(SlcanTalk, ABoardThatStartsAnewIsOpenedAgain)
{
    openLawicel(CanUse::operate);
    pass(5s);
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    said();
    hear("CAN BUS Shield init ok!\r\n");
    EXPECT_EQ(m_talk.state(), TalkState::opening);
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::notKnown});
    EXPECT_FALSE(m_talk.send(firstFrame, m_now));
    EXPECT_EQ(pass(200ms), "C\r");
    hear("\r");
    answer("V\r", "V1.0\r");
    answer("?\r", "\a");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
}

TEST_F(SlcanTalk, LateAnswersOfOpeningAreNotThoseOfTheRate)
{
    open(CanUse::operate);
    EXPECT_EQ(pass(400ms), "C\rV\r?\r");
    hear("\aV1013\r"); // C, V
    EXPECT_EQ(pass(399ms), "") << "that of the probe may still come";
    hear("\a");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
}

// Of a program that had the adapter before, say.
TEST_F(SlcanTalk, AnswersToWhatSomebodyElseHasAskedAreNotThoseOfOpening)
{
    open(CanUse::operate);
    answer("C\r", "\r");
    answer("V\r", "\a");
    answer("?\r", "\a"); // C
    answer("S5\r", "V1013\r\a\r");
    EXPECT_EQ(pass(199ms), "");
    EXPECT_EQ(pass(1ms), "C\r");
    hear("\a");
    answer("V\r", "V1013\r");
    answer("?\r", "\a");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
}

TEST_F(SlcanTalk, AnOpeningThatIsBegunAnewWaitsForAnswersToThatOfBefore)
{
    open(CanUse::watch);
    EXPECT_EQ(said(), "C\r");
    open(CanUse::operate);
    EXPECT_EQ(said(), "C\r");
    hear("\r"); // to the first
    EXPECT_EQ(said(), "V\r");
    hear("\a"); // to the second
    hear("V1013\r");
    EXPECT_EQ(said(), "?\r");
    hear("\a");
    answer("S5\r", "\r");
    answer("O\r", "\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
}

TEST_F(SlcanTalk, AnswersGoToTheOldestThatWaits)
{
    openLawicel(CanUse::operate);
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    EXPECT_TRUE(m_talk.send(secondFrame, m_now));
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    EXPECT_EQ(said(), "t1010\rt1020\rt1010\r");
    hear("z\r\a");
    EXPECT_EQ(m_talk.takeNews().fates, (SlcanFates{CanFate::done, CanFate::refused}));
    hear("\r");
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::done});
}

TEST_F(SlcanTalk, ALateRefusalIsNotThatOfALaterFrame)
{
    openLawicel(CanUse::operate);
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    said();
    EXPECT_EQ(pass(1s), "V\rF\r") << "whether it answers in turn";
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::notKnown});
    EXPECT_TRUE(m_talk.send(secondFrame, m_now));
    EXPECT_EQ(said(), "t1020\r");
    hear("\aV1013\rF00\rz\r");
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::done}) << "the refusal was that of the first";
}

TEST_F(SlcanTalk, AnAnswerThatWasLostShiftsNoOther)
{
    openLawicel(CanUse::operate);
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    said();
    EXPECT_EQ(pass(1s), "V\rF\r");
    hear("V1013\rF00\r");
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::notKnown});
    EXPECT_TRUE(m_talk.send(secondFrame, m_now));
    hear("\a");
    EXPECT_EQ(m_talk.takeNews().fates, SlcanFates{CanFate::refused});
}

TEST_F(SlcanTalk, TooManyWithoutAnswerHaveToWait)
{
    openLawicel(CanUse::operate);
    for (int i = 0; i < 16; ++i)
        EXPECT_TRUE(m_talk.send(firstFrame, m_now));
    EXPECT_FALSE(m_talk.send(firstFrame, m_now));
    hear("z\r");
    EXPECT_TRUE(m_talk.send(firstFrame, m_now));
}

TEST_F(SlcanTalk, TellsTheStateOfALawicelAdapter)
{
    const struct
    {
        const char *answer;
        CanState state;
        std::uint32_t error;
        std::uint8_t detail;
    } table[] = {
        {"F00\r", CanState::active, 0, 0},        {"F04\r", CanState::warning, 0x04, 0x0C},
        {"F24\r", CanState::passive, 0x04, 0x30}, {"F80\r", CanState::active, 0x80, 0},
        {"FA4\r", CanState::passive, 0x84, 0x30}, {"F40\r", CanState::active, 0x02, 0},
        {"F09\r", CanState::active, 0x04, 0x01},  {"F02\r", CanState::active, 0x04, 0x02},
    };
    openLawicel(CanUse::operate);
    for (const auto &row : table) {
        EXPECT_EQ(pass(1s), "F\r") << row.answer;
        hear(row.answer);
        EXPECT_EQ(m_talk.status().state, row.state) << row.answer;
        const auto frames = m_talk.takeNews().frames;
        ASSERT_EQ(frames.size(), row.error != 0 ? 1U : 0U) << row.answer;
        if (row.error != 0) {
            EXPECT_TRUE(frames[0].isError);
            EXPECT_EQ(frames[0].id, row.error) << row.answer;
            EXPECT_EQ(frames[0].bytes[1], row.detail) << row.answer;
        }
    }
}

TEST_F(SlcanTalk, AStateThatLastsIsToldOnce)
{
    openLawicel(CanUse::watch);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(pass(1s), "F\r");
        hear("F24\r");
    }
    EXPECT_EQ(m_talk.takeNews().frames.size(), 1U);
}

TEST_F(SlcanTalk, StampedFramesHaveTheTimeOfTheirStamp)
{
    openLawicel(CanUse::watch);
    hear("t0000EA5F\r");
    m_now += 30ms;
    hear("t00000009\r");
    const auto frames = m_talk.takeNews().frames;
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_GE(*frames[1].time - *frames[0].time, 10ms);
    EXPECT_LE(*frames[1].time - *frames[0].time, 11ms) << "not those of their arrival";
}

TEST_F(SlcanTalk, TornFramesAreCountedAndNothingElse)
{
    openLawicel(CanUse::watch);
    pass(5s);
    hear("852AABB\rt1\xFF\r");
    EXPECT_EQ(m_talk.state(), TalkState::open);
    EXPECT_TRUE(m_talk.takeNews().frames.empty());
    EXPECT_EQ(m_talk.skipped(), 7U + 3U);
}

TEST(SlcanRate, At800TheRateIsNotSureUnlessItIsALawicelAdapter)
{
    for (const bool isLawicel : {true, false}) {
        SlcanConversation talk(slcanPort, 800'000);
        talk.open(CanUse::operate, false, false, 0s);
        talk.received("\r", 0s);
        talk.received(isLawicel ? "V1013\r" : "V2.0\r", 0s);
        talk.received("\a", 0s);
        talk.received("\r", 0s);
        talk.received("\r", 0s);
        ASSERT_EQ(talk.state(), TalkState::open);
        EXPECT_EQ(talk.mayRunAt750(), !isLawicel);
        EXPECT_EQ(talk.status().rate, isLawicel ? std::optional(800'000) : std::nullopt);
    }
}

} // namespace
} // namespace codewheel
