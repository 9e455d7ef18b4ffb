// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_fraction_bits.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Lines = std::vector<std::string>;

struct ReadRow
{
    Parameter parameter;
    const char *letters;
    const char *answer;
    std::int64_t value;
};

// Manual, "Read only parameters" and its examples: all numbers are hexadecimal.
const ReadRow readRows[] = {
    {Parameter::operatingParameters, "O", "7005", 0x7005},
    {Parameter::direction, "O", "7005", 1},
    {Parameter::direction, "O", "7004", 0},
    {Parameter::scaling, "O", "7005", 1},
    {Parameter::scaling, "O", "7001", 0},
    {Parameter::measuringRange, "M", "02000000", 33'554'432},
    {Parameter::steps, "D", "0360", 864},
    {Parameter::preset, "S", "00005200", 0x5200},
    {Parameter::alarms, "A", "4000", 0x4000},
    {Parameter::warnings, "E", "9800", 0x9800},
    {Parameter::operatingTime, "T", "000004D2", 1234},
    {Parameter::offset, "C", "FFFFFFFE", 0xFFFFFFFE},
    {Parameter::serialNumber, "N", "00A1B2C3", 0x00A1B2C3},
    {Parameter::upperLimit, "H", "00100000", 0x100000},
    {Parameter::lowerLimit, "L", "00000100", 0x100},
    {Parameter::scalingFactor, "F", "1F400000", 0x1F400000},
    {Parameter::deviceCode, "B", "A000", 0xA000},
    {Parameter::revolutions, "U", "0120", 288},
};

TEST(EscRead, ReadsEveryValueOfTheTableTwice)
{
    for (const ReadRow &row : readRows) {
        EscBench bench;
        bench.settle();
        bench.has[row.letters] = row.answer;
        const Outcome &outcome = bench.finish(ReadParameters{{row.parameter}});
        EXPECT_TRUE(outcome.result);
        EXPECT_EQ(outcome.read, (ParameterValues{{row.parameter, row.value}})) << row.letters;
        EXPECT_EQ(bench.known[row.parameter].evidence, Evidence::read);
        EXPECT_EQ(bench.count(row.letters), 2) << row.letters;
        EXPECT_EQ(outcome.eepromWrites, 0);
        EXPECT_EQ(outcome.leftIn, EncoderState::operation);
    }
}

TEST(EscRead, EverythingThatCanBeReadIsRead)
{
    EscBench bench;
    bench.settle();
    const Catalog catalog = Catalog::builtIn();
    const auto all = catalog.find(u"kuebler-esc-rs485")->readableValues();
    EXPECT_EQ(all.size(), 16u);
    const Outcome &outcome = bench.finish(ReadParameters{all});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.read.size(), all.size());
}

TEST(EscRead, ALieIsNotTaken)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("D", "0368");
    bench.has["D"] = "0360";
    const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps}});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(valueOf(outcome.read, Parameter::steps), 864);
    EXPECT_EQ(bench.count("D"), 4) << "a try of two that agree";
}

TEST(EscRead, ReadsThatNeverAgreeAreRefusedAndTheOthersRead)
{
    EscBench bench({.readTries = 2});
    bench.settle();
    for (const char *answer : {"0360", "0361", "0362", "0363"})
        bench.answerNext("D", answer);
    const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps, Parameter::lowerLimit}});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::readsDisagree);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{Parameter::steps, std::int64_t{0x362}, std::int64_t{0x363}}));
    EXPECT_EQ(outcome.read, (ParameterValues{{Parameter::lowerLimit, 0x100}}));
    EXPECT_EQ(bench.value(Parameter::steps), std::nullopt);
    EXPECT_EQ(bench.count("D"), 4);
}

TEST(EscRead, ACommandTheEncoderDoesNotKnowLeavesTheOthers)
{
    for (const auto &[answer, id] :
         {std::pair("03", EscRefusalId::commandUnknown), std::pair("05", EscRefusalId::outOfRange)}) {
        EscBench bench;
        bench.settle();
        bench.has["T"] = answer;
        const Outcome &outcome = bench.finish(ReadParameters{{Parameter::operatingTime, Parameter::offset}});
        ASSERT_FALSE(outcome.result);
        EXPECT_EQ(outcome.result.error().id, id);
        EXPECT_EQ(outcome.result.error().arguments, (std::vector<RefusalArgument>{QStringLiteral("03T")}));
        EXPECT_EQ(outcome.read, (ParameterValues{{Parameter::offset, 0}}));
    }
}

// A request damaged on its way also gets an error.
TEST(EscRead, AnErrorIsBelievedWhenTheNextReadSaysTheSame)
{
    for (const char *error : {"03", "05"}) {
        EscBench bench;
        bench.settle();
        bench.answerNext("D", error);
        const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps}});
        EXPECT_TRUE(outcome.result);
        EXPECT_EQ(valueOf(outcome.read, Parameter::steps), 8192);
        EXPECT_EQ(bench.count("D"), 4) << "a try of two that agree";
    }
}

TEST(EscRead, AnErrorAndAValueDisagree)
{
    EscBench bench({.readTries = 1});
    bench.settle();
    bench.answerNext("D", "03");
    const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps}});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{Parameter::steps, QStringLiteral("03"), std::int64_t{8192}}));
}

// Manual, "Scaling factor": 1F400000h is 8000 of 8192 steps with 29 fraction bits
TEST(EscRead, TheFormatOfTheScalingFactorIsDetermined)
{
    EscBench bench;
    bench.settle();
    bench.has["F"] = "1F400000";
    bench.has["D"] = "1F40";
    bench.has["M"] = "01F40000";
    EXPECT_EQ(fractionBitsOf(bench.finish(fractionBitsJob())), 29);
    bench.has["F"] = "0FA00000";
    EXPECT_EQ(fractionBitsOf(bench.finish(fractionBitsJob())), 28);
    bench.has["F"] = "12345678";
    const auto refused = fractionBitsOf(bench.finish(fractionBitsJob()));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(), (Refusal{RefusalKind::device,
                                        EscRefusalId::factorFitsNothing,
                                        {Word{0x12345678}, std::int64_t{8000}, std::int64_t{0x1F40000}}}));
    bench.isOn = false;
    EXPECT_EQ(fractionBitsOf(bench.finish(fractionBitsJob())).error().id, RefusalId::escNoAnswer);
}

TEST(EscRead, SilenceEndsTheJob)
{
    EscBench bench;
    bench.settle();
    bench.isOn = false;
    const Outcome &outcome = bench.finish(ReadParameters{{Parameter::steps, Parameter::offset}});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::escNoAnswer);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("03D"), std::int64_t{3}}));
    EXPECT_EQ(bench.jobLog(), (Lines{"03D"}));
    EXPECT_FALSE(bench.driver.busy());
}

TEST(EscRead, StepsAreTheRequests)
{
    EscBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::steps, Parameter::direction}});
    ASSERT_EQ(bench.progress.steps.size(), 2u);
    EXPECT_EQ(bench.progress.steps[0].effect, Effect::reads);
    EXPECT_EQ(bench.progress.steps[0].line, "03D");
    EXPECT_EQ(bench.progress.steps[1].line, "03O");
    EXPECT_EQ(bench.progress.steps[1].parameter(), Parameter::direction);
}

TEST(EscRead, ByHandNothingIsWaitedFor)
{
    EscBench bench;
    bench.settle();
    EXPECT_TRUE(bench.finish(ReadParameters{{Parameter::steps}}, Pace::byHand).result);
}

TEST(EscRead, OneJobAtATime)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(ReadParameters{{Parameter::steps}}));
    EXPECT_TRUE(bench.driver.busy());
    EXPECT_EQ(bench.driver.begin(9, ReadParameters{{Parameter::steps}}, Pace::byItself, bench.now).error().id,
              RefusalId::jobRunning);
}

} // namespace
} // namespace codewheel
