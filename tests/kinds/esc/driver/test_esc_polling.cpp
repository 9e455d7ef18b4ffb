// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

bool isPosition(const std::string &line)
{
    return lettersOf(line) == "P";
}

// Manual, "Read actual Position": <ESC>05P, answered 00001235
TEST(EscPolling, ShowsThePositionOfTheManual)
{
    EscBench bench({}, {5});
    EXPECT_EQ(bench.driver.reading().state, EncoderState::notSeen);
    bench.step();
    EXPECT_EQ(bench.log.front(), "05P");
    EXPECT_EQ(bench.driver.reading().position, 0x1235);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_FALSE(bench.driver.reading().suspect);
}

// Manual, terminal assignment, note 1
TEST(EscPolling, NeverAsksForThePositionFasterThanEveryTenMilliseconds)
{
    for (const Instant wanted : {Instant{0}, Instant{1ms}, Instant{10ms}, Instant{50ms}}) {
        EscBench bench({.positionInterval = wanted});
        bench.run(3s);
        std::optional<Instant> last;
        int positions = 0;
        for (std::size_t i = 0; i < bench.log.size(); ++i) {
            if (!isPosition(bench.log[i]))
                continue;
            if (last) {
                EXPECT_GE(bench.times[i] - *last, std::max(wanted, Instant{10ms}));
            }
            last = bench.times[i];
            ++positions;
        }
        EXPECT_GE(positions, wanted == Instant{50ms} ? 55 : 250) << wanted.count();
    }
}

TEST(EscPolling, APositionIsNeverMoreThanOneRequestLate)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(
        bench.begin(ReadParameters{{Parameter::steps, Parameter::lowerLimit, Parameter::upperLimit}}));
    bench.run(5s);
    ASSERT_TRUE(bench.outcome);
    for (std::size_t i = 1; i < bench.log.size(); ++i)
        EXPECT_TRUE(isPosition(bench.log[i]) || isPosition(bench.log[i - 1])) << i;
}

TEST(EscPolling, ReadsTheIdentityOnceAtFirstContact)
{
    EscBench bench;
    bench.run(5s);
    for (const char *letters : {"V", "N", "B"})
        EXPECT_EQ(bench.count(letters), 2) << letters << ": until two reads agree";
    EXPECT_EQ(bench.value(Parameter::serialNumber), 0x00A1B2C3);
    EXPECT_EQ(bench.value(Parameter::deviceCode), 0x8000);
    EXPECT_EQ(bench.driver.version(), QStringLiteral("5882 HW 1.0 SW 2.04"));
    EXPECT_EQ(bench.value(Parameter::lineAddress), 3);
    EXPECT_EQ(bench.value(Parameter::baudRate), 19200);
}

TEST(EscPolling, ADamagedIdentityIsReadAgain)
{
    EscBench bench;
    bench.answerNext("N", "00A1B2C8");
    bench.run(2s);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 0x00A1B2C3);
    EXPECT_EQ(bench.count("N"), 4);
}

// Two reads that never agree, as with two encoders at one address: everything else is still polled.
TEST(EscPolling, WhatDoesNotAgreeIsPutOffAndKeepsNothingElseBack)
{
    EscBench bench;
    for (int i = 0; i < 50; ++i) {
        bench.answerNext("N", "00000001");
        bench.answerNext("N", "00000002");
    }
    bench.run(900ms);
    const int triedAtOnce = bench.count("N");
    EXPECT_EQ(bench.value(Parameter::deviceCode), 0x8000);
    EXPECT_EQ(bench.driver.reading().warnings, 0x8000);
    EXPECT_EQ(bench.value(Parameter::serialNumber), std::nullopt);
    EXPECT_LE(triedAtOnce, 2 * 2 * EscSettings().readTries) << "at first, and with the warnings";
    bench.run(5s);
    EXPECT_GT(bench.count("N"), triedAtOnce) << "with the warnings, again and again";
    EXPECT_NEAR(bench.count("A"), 6, 1);
}

TEST(EscPolling, WhatTheEncoderDoesNotKnowIsNotAskedAgain)
{
    EscBench bench;
    bench.has["B"] = "03";
    bench.run(5s);
    EXPECT_EQ(bench.count("B"), 2) << "one might have been a damaged request";
    EXPECT_EQ(bench.value(Parameter::deviceCode), std::nullopt);
    EXPECT_EQ(bench.count("V"), 2);
}

TEST(EscPolling, OneErrorToAReadIsNotBelieved)
{
    EscBench bench;
    bench.answerNext("N", "03");
    bench.answerNext("E", "03");
    bench.run(2s);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 0x00A1B2C3);
    EXPECT_EQ(bench.driver.reading().warnings, 0x8000);
}

// Manual, "Alarm Parameters" and "Warning Parameters"
TEST(EscPolling, WarningsAndAlarmsAreSeenWithinASecond)
{
    EscBench bench;
    bench.settle();
    EXPECT_EQ(bench.driver.reading().warnings, 0x8000);
    EXPECT_EQ(bench.driver.reading().alarms, 0x0000);
    bench.has["A"] = "5000";
    bench.has["E"] = "9800";
    bench.run(1100ms);
    EXPECT_EQ(bench.driver.reading().alarms, 0x5000);
    EXPECT_EQ(bench.driver.reading().warnings, 0x9800);
    EXPECT_EQ(bench.value(Parameter::alarms), 0x5000);
    bench.settle();
    bench.run(10s);
    EXPECT_NEAR(bench.count("A"), 10, 1);
    EXPECT_NEAR(bench.count("E"), 10, 1);
}

TEST(EscPolling, AnAlarmThatOneDamagedAnswerMadeUpIsNotShown)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("A", "4000");
    bench.run(3s);
    EXPECT_EQ(bench.driver.reading().alarms, 0x0000);
    EXPECT_EQ(bench.value(Parameter::alarms), 0x0000);
}

// Manual, "Read Warning Parameters": 0098 is read as the bits 15, 12 and 11
TEST(EscPolling, TheBytesOfTheWarningsCanBeSwapped)
{
    EscBench bench({.swapWarningBytes = true});
    bench.has["E"] = "0098";
    bench.run(1s);
    EXPECT_EQ(bench.driver.reading().warnings, 0x9800);
    EXPECT_EQ(bench.value(Parameter::warnings), 0x9800);
    EXPECT_EQ(bench.driver.reading().alarms, 0x0000);
}

TEST(EscPolling, AnEncoderThatFallsSilentIsAskedSeldomAndToldOnce)
{
    EscBench bench;
    bench.settle();
    bench.isOn = false;
    bench.run(20s);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::silent);
    EXPECT_EQ(bench.driver.reading().position, 0x1235) << "the last one is still there";
    ASSERT_EQ(bench.countOf(MessageId::encoderSilent), 1);
    EXPECT_EQ(bench.messages.back().arguments, (std::vector<RefusalArgument>{std::int64_t{9}}));
    EXPECT_EQ(bench.messages.back().severity, Severity::fault);
    bench.settle();
    bench.run(10s);
    EXPECT_LE(bench.log.size(), 11u);
    EXPECT_GE(bench.log.size(), 9u);

    bench.isOn = true;
    bench.run(3s);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_EQ(bench.countOf(MessageId::encoderAnswers), 1);
    EXPECT_GT(bench.count("P"), 100) << "at the old rate again";
    EXPECT_EQ(bench.count("N"), 2) << "it may be another";
}

TEST(EscPolling, OneUnansweredRequestIsNoSilence)
{
    EscBench bench;
    bench.settle();
    bench.next("P", EscBench::Fate::lost);
    bench.next("P", EscBench::Fate::lost);
    bench.run(5s);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_TRUE(bench.messages.empty());
}

TEST(EscPolling, NothingIsKnownOfAnotherEncoderAfterASilence)
{
    EscBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::steps}});
    ASSERT_EQ(bench.value(Parameter::steps), 8192);
    bench.isOn = false;
    bench.run(10s);
    EXPECT_EQ(bench.value(Parameter::steps), 8192);
    bench.isOn = true;
    bench.has["N"] = "00000007";
    bench.goOnTo(esc::Command::serialNumber);
    EXPECT_EQ(bench.value(Parameter::serialNumber), std::nullopt) << "until it has told it";
    bench.run(3s);
    EXPECT_EQ(bench.value(Parameter::steps), std::nullopt);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 7);
    EXPECT_EQ(bench.value(Parameter::lineAddress), 3);
}

TEST(EscPolling, WhenTheLineIsBackTheEncoderIsAskedWhoItIs)
{
    EscBench bench;
    bench.settle();
    bench.driver.lost(bench.now);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::notSeen);
    bench.now += 5s;
    bench.has["N"] = "00000007";
    bench.run(1s);
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_EQ(bench.value(Parameter::serialNumber), 7);
    EXPECT_TRUE(bench.messages.empty()) << "the line tells it";
}

TEST(EscPolling, TheOnlyEncoderOfALineIsAskedAtTheMasterAddress)
{
    EscBench bench({}, EscLineAddress::master());
    bench.address = {0x12};
    bench.run(1s);
    EXPECT_EQ(bench.log.front(), "00P");
    EXPECT_EQ(bench.driver.reading().position, 0x1235);
    EXPECT_EQ(bench.value(Parameter::lineAddress), std::nullopt) << "it may have any";
}

} // namespace
} // namespace codewheel
