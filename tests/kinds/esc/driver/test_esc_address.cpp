// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Fate = EscBench::Fate;
using Lines = std::vector<std::string>;

WriteParameters address(std::int64_t value)
{
    return {.values = {{Parameter::lineAddress, value}}, .previous = {}};
}

WriteParameters baudRate(std::int64_t value)
{
    return {.values = {{Parameter::baudRate, value}}, .previous = {}};
}

TEST(EscAddress, GoesAsTwoHexadecimalDigitsAndIsFoundThere)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome = bench.finish(address(21));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Lines{"03N", "03N", "03X15", "15N"}));
    EXPECT_EQ(bench.driver.address(), EscLineAddress{21});
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::lineAddress, 21}}));
    EXPECT_EQ(bench.value(Parameter::lineAddress), 21);
    ASSERT_EQ(bench.countOf(EscMessageId::lineAddressChanged), 1);
    EXPECT_EQ(bench.messages.back().arguments,
              (std::vector<RefusalArgument>{EscLineAddress{3}.shown(), EscLineAddress{21}.shown()}));
    bench.log.clear();
    bench.run(std::chrono::seconds(1));
    EXPECT_EQ(bench.log.front(), "15P");
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    EXPECT_EQ(bench.countOf(MessageId::encoderSilent), 0);
}

// "address will be set to 21" for <ESC>02X21: the manual leaves the notation open.
TEST(EscAddress, IsFoundAtTheDecimalReadingAndReported)
{
    EscBench bench;
    bench.readsAddressAsDecimal = true;
    bench.settle();
    const Outcome &outcome = bench.finish(address(0x15));
    EXPECT_EQ(bench.jobLog(), (Lines{"03N", "03N", "03X15", "15N", "0FN"}));
    EXPECT_EQ(bench.driver.address(), EscLineAddress{15});
    ASSERT_FALSE(outcome.result) << "it is not what was asked for";
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{Parameter::lineAddress, std::int64_t{21}, std::int64_t{15}}));
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::lineAddress, 15}}));
    EXPECT_EQ(bench.countOf(EscMessageId::lineAddressChanged), 1);
    EXPECT_EQ(bench.value(Parameter::lineAddress), 15);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscAddress, AnotherSerialNumberIsNotTakenForIt)
{
    EscBench bench;
    bench.readsAddressAsDecimal = true;
    bench.settle();
    ASSERT_TRUE(bench.begin(address(0x15)));
    bench.runUntil([&] { return bench.count("X") == 1; });
    bench.answerNext("N", "00000009"); // a stranger, or a damaged answer: the search goes on
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.jobLog(), (Lines{"03N", "03N", "03X15", "15N", "0FN", "03N", "15N", "0FN"}));
    EXPECT_EQ(bench.driver.address(), EscLineAddress{15});
}

TEST(EscAddress, WithoutAnAnswerItIsFoundWhereItIs)
{
    struct Row
    {
        Fate fate;
        int found;
        std::optional<RefusalCode> why;
        int writes;
    };
    const Row rows[] = {{Fate::unanswered, 21, {}, 1}, {Fate::lost, 3, EscRefusalId::writeNotDone, 0}};
    for (const Row &row : rows) {
        EscBench bench;
        bench.settle();
        bench.next("X", row.fate);
        const Outcome &outcome = bench.finish(address(21));
        EXPECT_EQ(bench.driver.address().value, row.found);
        EXPECT_EQ(outcome.eepromWrites, row.writes);
        EXPECT_EQ(bench.count("X"), 1);
        EXPECT_EQ(bench.value(Parameter::lineAddress), row.found);
        ASSERT_EQ(outcome.result.has_value(), !row.why);
        if (row.why) {
            EXPECT_EQ(outcome.result.error().id, *row.why);
        }
    }
}

TEST(EscAddress, AcceptedAndStillAtTheOldOneIsToldSo)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("X", "");
    const Outcome &outcome = bench.finish(address(21));
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(bench.driver.address(), EscLineAddress{3});
    EXPECT_EQ(bench.countOf(EscMessageId::lineAddressChanged), 0);
}

TEST(EscAddress, NowhereFoundTellsWhereItWasLookedFor)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(address(21)));
    bench.runUntil([&] { return bench.count("X") == 1; });
    bench.isOn = false;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::notFoundAgain);
    EXPECT_EQ(bench.outcome->result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("15h (21); 0Fh (15); 03h (3)")}));
    EXPECT_EQ(bench.jobLog(), (Lines{"03N", "03N", "03X15", "15N", "0FN", "03N", "15N", "0FN", "03N"}));
    EXPECT_EQ(bench.value(Parameter::lineAddress), std::nullopt);
}

TEST(EscAddress, OnesThatAreTakenAreRefusedBeforehandInBothReadings)
{
    EscBench bench;
    bench.driver.setTaken({{{5}, QStringLiteral("Lift")}, {{0x12}, QStringLiteral("Slide")}});
    struct Row
    {
        int wanted;
        std::optional<int> taken;
    };
    for (const auto &[wanted, taken] :
         {Row{5, 5}, Row{0x12, 0x12}, Row{0x18, 0x12}, Row{6, {}}, Row{0x1F, {}}}) {
        const auto begun = bench.begin(address(wanted));
        EXPECT_EQ(begun.has_value(), !taken.has_value()) << wanted;
        if (!begun) {
            EXPECT_EQ(begun.error().id, RefusalId::lineAddressTaken);
            EXPECT_EQ(begun.error().arguments.front(),
                      RefusalArgument(EscLineAddress{static_cast<std::uint8_t>(*taken)}.shown()));
        }
        bench.driver.stop({RefusalKind::stopped, RefusalId::busStopped, {}}, bench.now);
    }
}

TEST(EscAddress, GoesLastSoThatAllElseReachesTheEncoder)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome = bench.finish(
        WriteParameters{.values = {{Parameter::lineAddress, 7}, {Parameter::direction, 0}}, .previous = {}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Lines{"03GD0", "03O", "03O", "03N", "03N", "03X07", "07N"}));
}

TEST(EscAddress, FromTheMasterAddressItGetsOne)
{
    EscBench bench({}, EscLineAddress::master());
    bench.address = {9};
    bench.settle();
    EXPECT_TRUE(bench.finish(address(4)).result);
    EXPECT_EQ(bench.driver.address(), EscLineAddress{4});
    EXPECT_EQ(bench.log.back().substr(0, 2), "04");
}

// Manual: <ESC>02Y1 changes to 9600 baud.
TEST(EscBaudRate, IsLookedForAtTheNewRate)
{
    EscBench bench({}, {2});
    bench.settle();
    const Outcome &outcome = bench.finish(baudRate(9600));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(), (Lines{"02N", "02N", "02Y1", "02N"}));
    EXPECT_EQ(bench.driver.wantedBaudRate(), 9600) << "until the line has it";
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::baudRate, 9600}}));
    ASSERT_EQ(bench.countOf(EscMessageId::baudRateChanged), 1);
    EXPECT_EQ(bench.messages.back().arguments,
              (std::vector<RefusalArgument>{std::int64_t{19200}, std::int64_t{9600}}));
    bench.run(std::chrono::seconds(2));
    EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    bench.driver.setLineBaudRate(9600);
    EXPECT_EQ(bench.driver.wantedBaudRate(), std::nullopt);
}

TEST(EscBaudRate, TheThreeRatesHaveTheNumbersOfTheManual)
{
    for (const auto &[rate, line] :
         {std::pair(19200, "03Y0"), std::pair(9600, "03Y1"), std::pair(4800, "03Y2")}) {
        EscBench bench;
        bench.settle();
        EXPECT_TRUE(bench.finish(baudRate(rate)).result);
        EXPECT_EQ(bench.jobLog().at(2), line);
    }
    EscBench bench;
    EXPECT_EQ(bench.begin(baudRate(38400)).error().id, RefusalId::valueNotAllowed);
}

TEST(EscBaudRate, WithoutAnAnswerItIsFoundWhereItIs)
{
    for (const Fate fate : {Fate::unanswered, Fate::lost}) {
        EscBench bench;
        bench.settle();
        bench.next("Y", fate);
        const Outcome &outcome = bench.finish(baudRate(4800));
        EXPECT_EQ(outcome.result.has_value(), fate == Fate::unanswered);
        if (!outcome.result) {
            EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeNotDone);
        }
        EXPECT_EQ(bench.value(Parameter::baudRate), fate == Fate::lost ? 19200 : 4800);
        EXPECT_EQ(bench.count("Y"), 1);
        bench.run(std::chrono::seconds(2));
        EXPECT_EQ(bench.driver.reading().state, EncoderState::operation);
    }
}

TEST(EscBaudRate, NowhereFoundTellsTheRates)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(baudRate(4800)));
    bench.runUntil([&] { return bench.count("Y") == 1; });
    bench.isOn = false;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::notFoundAgain);
    EXPECT_EQ(bench.outcome->result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("03h (3), 4800 Bd; 03h (3), 19200 Bd")}));
}

} // namespace
} // namespace codewheel
