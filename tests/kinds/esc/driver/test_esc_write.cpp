// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_refusals.h"
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Fate = EscBench::Fate;
using Lines = std::vector<std::string>;

WriteParameters writingAll(ParameterValues values, bool onlyWhatDiffers = false)
{
    return {.values = std::move(values), .onlyWhatDiffers = onlyWhatDiffers, .previous = {}};
}

struct WriteRow
{
    int address;
    Parameter parameter;
    std::int64_t value;
    Lines requests;
};

// Manual, "Programmable parameters" with its examples; GR and GT bring the scaling factor along, 32 bits with
// 29 fraction bits: 864/8192 = 03600000h, 100000h of 2000000h = 01000000h.
const WriteRow writeRows[] = {
    {3,
     Parameter::steps,
     0x360,
     {"03F", "03F", "03GR00000360", "03GF03600000", "03D", "03D", "03U", "03U", "03M", "03M", "03F", "03F"}},
    {0x12,
     Parameter::revolutions,
     0x120,
     {"12GM0120", "12D", "12D", "12U", "12U", "12M", "12M", "12F", "12F"}},
    {9,
     Parameter::measuringRange,
     0x100000,
     {"09F", "09F", "09GT00100000", "09GF01000000", "09D", "09D", "09U", "09U", "09M", "09M", "09F", "09F"}},
    {9, Parameter::lowerLimit, 0x100, {"09GL00000100", "09L", "09L"}},
    {9, Parameter::upperLimit, 0x100000, {"09GH00100000", "09H", "09H"}},
    {9,
     Parameter::scalingFactor,
     0x1F400000,
     {"09F", "09F", "09GF1F400000", "09D", "09D", "09U", "09U", "09M", "09M", "09F", "09F"}},
    {2, Parameter::direction, 1, {"02GD1", "02O", "02O"}},
    {2, Parameter::scaling, 0, {"02GS0", "02O", "02O"}},
};

bool isRead(const std::string &line)
{
    return line.size() == 3;
}

// The factor is sent with what needs it, in whatever order they are given; contradictions are refused.
TEST(EscWrite, StepsAndMeasuringRangeActThroughOneFactor)
{
    const ParameterValues together{{Parameter::measuringRange, 4'096'000}, {Parameter::steps, 1000}};
    for (const ParameterValues &values : {together, ParameterValues{together[1], together[0]}}) {
        EscBench bench;
        bench.settle();
        ASSERT_TRUE(bench.finish(writingAll(values)).result);
        EXPECT_EQ(bench.value(Parameter::scalingFactor), 1000 << 16) << "1000 / 8192 with 29 fraction bits";
    }
    EscBench bench;
    bench.settle();
    const ParameterValues apart{{Parameter::measuringRange, 0x20000}, {Parameter::steps, 1000}};
    const auto refused = bench.begin(writingAll(apart));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, RefusalId::valueNotAllowed);
    EXPECT_EQ(refused.error().arguments.front(), RefusalArgument(Parameter::steps));
    EXPECT_TRUE(bench.begin(writingAll({apart[0], apart[1], {Parameter::scalingFactor, 0x200'0000}})))
        << "the factor says which";
}

TEST(EscWrite, SendsTheRequestsOfTheManualAndReadsThemBack)
{
    for (const WriteRow &row : writeRows) {
        EscBench bench({}, {static_cast<std::uint8_t>(row.address)});
        bench.settle();
        const Outcome &outcome = bench.finish(writingAll({{row.parameter, row.value}}));
        EXPECT_TRUE(outcome.result) << row.requests.front();
        EXPECT_EQ(bench.jobLog(), row.requests);
        EXPECT_EQ(valueOf(outcome.written, row.parameter), row.value);
        EXPECT_EQ(bench.value(row.parameter), row.value);
        EXPECT_EQ(bench.known[row.parameter].evidence, Evidence::read);
        const auto writes = std::ranges::count_if(row.requests, [](auto &line) { return !isRead(line); });
        EXPECT_EQ(outcome.eepromWrites, writes);
        EXPECT_EQ(bench.eepromWrites, writes);
    }
}

// Manual, GR: "Number of revolutions is 4096".
TEST(EscWrite, StepsSetTheRevolutionsAndTheOutcomeSaysSo)
{
    EscBench bench;
    bench.has["U"] = "0010"; // 16
    bench.settle();
    const Outcome &alone = bench.finish(writingAll({{Parameter::steps, 1000}}));
    EXPECT_TRUE(alone.result);
    EXPECT_EQ(alone.setAlong, (ParameterValues{{Parameter::revolutions, 4096}}));
    EXPECT_EQ(bench.finish(writingAll({{Parameter::steps, 2000}})).setAlong, ParameterValues())
        << "they were so";
    const Outcome &both = bench.finish(writingAll({{Parameter::revolutions, 16}, {Parameter::steps, 1000}}));
    EXPECT_EQ(both.setAlong, ParameterValues());
    EXPECT_EQ(bench.has["U"], "0010");
}

TEST(EscWrite, WantedRevolutionsAreWrittenAgainWithTheSteps)
{
    EscBench bench;
    bench.has["U"] = "0010";
    bench.settle();
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::steps, 1000}, {Parameter::revolutions, 16}}, true));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.count("GM"), 1);
    EXPECT_EQ(bench.has["U"], "0010");
    EXPECT_EQ(outcome.alreadyThere, ParameterValues());

    bench.log.clear();
    bench.finish(writingAll({{Parameter::steps, 1000}, {Parameter::revolutions, 16}}, true));
    EXPECT_EQ(bench.count("GR") + bench.count("GM"), 0) << "both are there";
}

// 1000 steps for 16 revolutions; otherwise the factor would be that for 4096.
TEST(EscWrite, AMeasuringRangeBesideStepsKnowsThatTheyCountAllRevolutions)
{
    EscBench bench;
    bench.has["U"] = "0010";
    bench.settle();
    bench.finish(ReadParameters{{Parameter::revolutions}});
    const ParameterValues narrow{{Parameter::steps, 1000}, {Parameter::measuringRange, 16'000}};
    EXPECT_FALSE(bench.begin(writingAll(narrow))) << "over 4096 revolutions that are 4 steps each";
    const ParameterValues whole{{Parameter::steps, 1000}, {Parameter::measuringRange, 4'096'000}};
    EXPECT_TRUE(bench.finish(writingAll(whole)).result);
    EXPECT_EQ(bench.value(Parameter::scalingFactor), 1000 << 16);
}

TEST(EscWrite, TheFractionBitsOfTheFactorAreSettable)
{
    EscBench bench({.fractionBits = 30});
    bench.settle();
    bench.finish(writingAll({{Parameter::steps, 4096}}));
    EXPECT_EQ(bench.has["F"], "20000000");
}

TEST(EscWrite, AFactorThatIsGivenTakesThePlaceOfTheComputedOne)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::steps, 4096}, {Parameter::scalingFactor, 0x12345678}}));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.has["F"], "12345678");
    EXPECT_EQ(bench.count("GF"), 1);
}

// The factor for 1000 turns of 100000h steps: 100000h / (8192 * 1000)
TEST(EscWrite, TheFactorOfARangeKnowsTheRevolutions)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::measuringRange, 0x100000}, {Parameter::revolutions, 1000}}));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.has["U"], "03E8");
    EXPECT_EQ(bench.has["F"], "04189375");
    const Lines lines = bench.jobLog();
    EXPECT_EQ(Lines(lines.begin() + 2, lines.begin() + 5),
              (Lines{"03GM03E8", "03GT00100000", "03GF04189375"}));
}

TEST(EscWrite, OnlyWhatDiffersIsWritten)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome = bench.finish(writingAll(
        {{Parameter::steps, 8192}, {Parameter::direction, 1}, {Parameter::upperLimit, 0x200000}}, true));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.alreadyThere, (ParameterValues{{Parameter::steps, 8192}, {Parameter::direction, 1}}));
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::upperLimit, 0x200000}}));
    EXPECT_EQ(bench.count("GR") + bench.count("GF") + bench.count("GD"), 0);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscWrite, NothingIsWrittenWhereAllIsThere)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome = bench.finish(writingAll(
        {{Parameter::steps, 8192}, {Parameter::lineAddress, 3}, {Parameter::baudRate, 19200}}, true));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(outcome.alreadyThere.size(), 3u);
    EXPECT_EQ(outcome.eepromWrites, 0);
    for (const std::string &line : bench.jobLog())
        EXPECT_TRUE(isRead(line)) << line;
}

TEST(EscWrite, TheFactorGoesAlongAlthoughItIsThere)
{
    EscBench bench;
    bench.has["D"] = "1000";
    bench.settle();
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::steps, 8192}, {Parameter::scalingFactor, 0x20000000}}, true));
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.count("GR"), 1);
    EXPECT_EQ(bench.count("GF"), 1);
}

TEST(EscWrite, WhatIsRefusedEndsTheJobAndTheEncoderKeepsWhatItHad)
{
    for (const auto &[answer, id] :
         {std::pair("03", EscRefusalId::commandUnknown), std::pair("05", EscRefusalId::outOfRange)}) {
        EscBench bench;
        bench.settle();
        bench.answerNext("GL", answer);
        const Outcome &outcome =
            bench.finish(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::upperLimit, 0x300}}));
        ASSERT_FALSE(outcome.result);
        EXPECT_EQ(outcome.result.error().id, id);
        EXPECT_EQ(outcome.result.error().arguments,
                  (std::vector<RefusalArgument>{QStringLiteral("03GL00000200")}));
        EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200"}));
        EXPECT_EQ(outcome.eepromWrites, 0);
        EXPECT_TRUE(outcome.written.empty());
    }
}

TEST(EscWrite, WhatWasAcceptedBeforeARefusalIsReadBack)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("GF", "05");
    const Outcome &outcome = bench.finish(writingAll({{Parameter::steps, 4096}}));
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::outOfRange);
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::steps, 4096}}));
    EXPECT_EQ(bench.value(Parameter::steps), 4096);
    EXPECT_EQ(bench.value(Parameter::scalingFactor), 0x20000000) << "refused, so it is as it was";
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscWrite, AnAcceptedWriteThatReadsOtherwiseIsNotBelieved)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("GL", "");
    const Outcome &outcome = bench.finish(writingAll({{Parameter::lowerLimit, 0x200}}));
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(
        outcome.result.error().arguments,
        (std::vector<RefusalArgument>{Parameter::lowerLimit, std::int64_t{0x200}, std::int64_t{0x100}}));
    EXPECT_TRUE(outcome.written.empty());
    EXPECT_EQ(bench.value(Parameter::lowerLimit), 0x100);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscWrite, ALieInReadingBackIsReadAgain)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("L", "00000201");
    EXPECT_TRUE(bench.finish(writingAll({{Parameter::lowerLimit, 0x200}})).result);
    EXPECT_EQ(bench.count("GL"), 1);
}

TEST(EscWrite, WithoutAnAnswerTheEncoderIsReadDone)
{
    EscBench bench;
    bench.settle();
    bench.next("GL", Fate::unanswered);
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::direction, 0}}));
    EXPECT_TRUE(outcome.result) << "it was done, and the job went on";
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L", "03L", "03GD0", "03O", "03O"}));
    EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::lowerLimit, 0x200}, {Parameter::direction, 0}}));
    EXPECT_EQ(outcome.eepromWrites, 2);
}

TEST(EscWrite, WithoutAnAnswerTheEncoderIsReadNotDone)
{
    EscBench bench;
    bench.settle();
    bench.next("GL", Fate::lost);
    const Outcome &outcome =
        bench.finish(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::direction, 0}}));
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeNotDone);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("03GL00000200")}));
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L", "03L"})) << "never sent twice";
    EXPECT_EQ(bench.value(Parameter::lowerLimit), 0x100);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_TRUE(outcome.written.empty());
}

TEST(EscWrite, WithoutAnAnswerAndUnreadableNothingIsKnown)
{
    for (const bool isDone : {false, true}) {
        EscBench bench;
        bench.settle();
        bench.finish(ReadParameters{{Parameter::lowerLimit}});
        bench.log.clear();
        bench.next("GL", isDone ? Fate::unanswered : Fate::lost);
        bench.always("L", Fate::lost);
        const Outcome &outcome =
            bench.finish(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::direction, 0}}));
        ASSERT_FALSE(outcome.result);
        EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeUnknown);
        EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L"}));
        EXPECT_EQ(bench.value(Parameter::lowerLimit), std::nullopt) << "neither old nor new is claimed";
        EXPECT_EQ(outcome.eepromWrites, 1) << "it may have been stored";
    }
}

TEST(EscWrite, TheEncoderIsUnpluggedInTheMiddle)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::upperLimit, 0x300}})));
    bench.runUntil([&] { return bench.count("GH") == 1; });
    bench.isOn = false;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::escNoAnswer);
    EXPECT_EQ(bench.outcome->written.size(), 2u) << "both were accepted";
    EXPECT_EQ(bench.known[Parameter::upperLimit].evidence, Evidence::echoed);
    EXPECT_EQ(bench.known[Parameter::lowerLimit].evidence, Evidence::read);
}

TEST(EscWrite, WhatCouldNotBeSentIsNotSentWhenTheEncoderIsBack)
{
    EscBench bench;
    bench.settle();
    bench.isOn = false;
    ASSERT_TRUE(bench.begin(writingAll({{Parameter::lowerLimit, 0x200}})));
    bench.run(std::chrono::milliseconds(100));
    bench.now += std::chrono::seconds(2); // others on the line are asked, and do not answer either
    bench.isOn = true;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::notSentInTime);
    EXPECT_EQ(bench.count("GL"), 0);
    EXPECT_EQ(bench.outcome->eepromWrites, 0);
}

// The first of a group is read at once, before the factor puts it into effect. Manual, note on GR, GT and GF:
// they take effect once the factor has been sent, so what D and M report before says nothing about a command
// without an answer.
TEST(EscWrite, TheOldScalingIsNoProofThatItWasNotWritten)
{
    const std::tuple<Parameter, std::int64_t, std::string> scaling[] = {
        {Parameter::steps, 4096, "GR"}, {Parameter::measuringRange, 0x100000, "GT"}};
    for (const auto &[parameter, value, letters] : scaling) {
        EscBench bench;
        bench.settle();
        bench.next(letters, Fate::lost); // or carried out, but not shown yet
        const Outcome &outcome =
            bench.finish(writingAll({{Parameter::lowerLimit, 0x200}, {parameter, value}}));
        ASSERT_FALSE(outcome.result);
        EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeUnknown);
        EXPECT_EQ(outcome.eepromWrites, 2) << "with that of the limit";
        EXPECT_EQ(bench.eepromWrites, 2);
        EXPECT_EQ(outcome.written, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
        EXPECT_EQ(bench.count("GF"), 0);
        EXPECT_EQ(bench.count(letters), 1);
    }
}

TEST(EscWrite, AnUnansweredWriteOfTheScalingIsReadBeforeTheNext)
{
    EscBench bench;
    bench.settle();
    bench.next("GR", Fate::unanswered);
    const Outcome &outcome = bench.finish(writingAll({{Parameter::steps, 4096}}));
    EXPECT_TRUE(outcome.result);
    const Lines lines = bench.jobLog();
    EXPECT_EQ(Lines(lines.begin(), lines.begin() + 6),
              (Lines{"03F", "03F", "03GR00001000", "03D", "03D", "03GF10000000"}));
    EXPECT_EQ(bench.count("GR"), 1);
}

TEST(EscWrite, ByHandEachWriteWaitsAndThePositionGoesOn)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(
        bench.begin(writingAll({{Parameter::lowerLimit, 0x200}, {Parameter::direction, 0}}), Pace::byHand));
    bench.run(2s);
    EXPECT_EQ(bench.jobLog(), Lines());
    EXPECT_TRUE(bench.progress.waitsForUser);
    EXPECT_EQ(bench.progress.steps[0].line, "03P");
    EXPECT_EQ(bench.progress.steps[1].line, "03GL00000200");
    EXPECT_GT(bench.count("P"), 150);
    bench.driver.proceed();
    bench.run(2s);
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L", "03L"}));
    EXPECT_EQ(bench.progress.index, 3);
    EXPECT_TRUE(bench.progress.waitsForUser);
    EXPECT_EQ(bench.progress.confirmed, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
    bench.driver.proceed();
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_TRUE(bench.outcome->result);
}

TEST(EscWrite, AnotherDirectionMakesNoPositionSuspect)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(writingAll({{Parameter::direction, 0}})));
    bench.runUntil([&] { return bench.count("GD") == 1; });
    bench.has["P"] = "01FFEDCA";
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.driver.figures().suspect, 0);
}

TEST(EscWrite, WhatATerminalWroteIsCountedAndNotKnownAnyMore)
{
    EscBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::lowerLimit}});
    const esc::Request request{{3}, esc::Command::writeLowerLimit, 0x200};
    bench.driver.observe(request, {.answer = esc::Answer{esc::Answer::Kind::outOfRange, 0, "05"}, .sent = 1},
                         bench.now);
    bench.step();
    EXPECT_EQ(bench.eepromWrites, 0);
    EXPECT_EQ(bench.value(Parameter::lowerLimit), 0x100);
    bench.driver.observe(request, {.answer = esc::Answer{esc::Answer::Kind::accepted, 0, {}}, .sent = 1},
                         bench.now);
    bench.step();
    EXPECT_EQ(bench.eepromWrites, 1);
    EXPECT_EQ(bench.value(Parameter::lowerLimit), std::nullopt);
    bench.driver.observe(request, {}, bench.now); // dropped before it was sent
    bench.step();
    EXPECT_EQ(bench.eepromWrites, 1);
}

} // namespace
} // namespace codewheel
