// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_refusals.h"
#include "tests/kinds/esc/driver/esc_bench.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>
#include <memory>

namespace codewheel {
namespace {

using Fate = EscBench::Fate;
using Lines = std::vector<std::string>;

constexpr std::int64_t wanted = 0x5200;

// Manual: <ESC>03GP00005200 sets the position of device 03 to 5200h.
TEST(EscPreset, SetsThePositionAndTellsItBeforeAndAfter)
{
    EscBench bench;
    bench.settle();
    const Outcome &outcome = bench.finish(SetPreset{.value = wanted});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.jobLog(),
              (Lines{"03O", "03O", "03M", "03M", "03S", "03S", "03GP00005200", "03S", "03S"}));
    EXPECT_EQ(outcome.positionBefore, 0x1235);
    EXPECT_EQ(outcome.positionAfter, wanted);
    EXPECT_EQ(outcome.eepromWrites, 1);
    EXPECT_EQ(bench.value(Parameter::preset), wanted);
    EXPECT_EQ(bench.driver.figures().suspect, 0) << "the jump is ours";
}

// Nothing had been read from the encoder before.
TEST(EscPreset, BeyondTheMeasuringRangeItIsNotSent)
{
    EscBench bench;
    bench.has["M"] = "00000640"; // 1600
    bench.settle();
    const Outcome &outcome = bench.finish(SetPreset{.value = 5'000'000});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error(),
              (Refusal{RefusalKind::badInput,
                       RefusalId::valueOutOfRange,
                       {Parameter::preset, std::int64_t{5'000'000}, std::int64_t{1}, std::int64_t{1600}}}));
    EXPECT_EQ(bench.count("GP"), 0);
    EXPECT_EQ(outcome.eepromWrites, 0);
    EXPECT_FALSE(bench.driver.busy());
}

TEST(EscPreset, WithoutScalingTheMeasuringRangeDoesNotBindIt)
{
    EscBench bench;
    bench.has["M"] = "00000640";
    bench.has["O"] = "7001";
    bench.settle();
    EXPECT_TRUE(bench.finish(SetPreset{.value = 5'000'000}).result);
    EXPECT_EQ(bench.count("GP"), 1);
}

// The shaft may be elsewhere by then.
TEST(EscPreset, WhatCouldNotBeSentIsNotSentWhenTheEncoderIsBack)
{
    EscBench bench;
    bench.settle();
    bench.isOn = false;
    ASSERT_TRUE(bench.begin(SetPreset{.value = wanted}));
    bench.run(std::chrono::milliseconds(400));
    bench.now += std::chrono::seconds(2); // others on the line are asked, and do not answer either
    bench.isOn = true;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error(),
              (Refusal{RefusalKind::device, EscRefusalId::notSentInTime, {std::int64_t{2}}}));
    EXPECT_TRUE(
        refusalText(bench.outcome->result.error()).contains(QStringLiteral("so nothing was written.")))
        << "what reads was sent";
    EXPECT_EQ(bench.outcome->eepromWrites, 0);
    bench.run(std::chrono::seconds(5));
    EXPECT_EQ(bench.count("GP"), 0);
    EXPECT_FALSE(bench.driver.busy());
}

// On a line on which others are silent its turn may come late.
TEST(EscPreset, ItIsNotSentIfItsTurnComesTooLate)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(SetPreset{.value = wanted}));
    bench.now += std::chrono::seconds(3);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::notSentInTime);
    EXPECT_EQ(bench.count("GP"), 0);
}

TEST(EscPreset, AShortSilenceDoesNotKeepItFromBeingSent)
{
    EscBench bench;
    bench.settle();
    bench.isOn = false;
    ASSERT_TRUE(bench.begin(SetPreset{.value = wanted}));
    bench.run(std::chrono::milliseconds(600));
    bench.isOn = true;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_TRUE(bench.outcome->result);
    EXPECT_EQ(bench.count("GP"), 1);
}

TEST(EscPreset, TurningOnMeanwhileIsNoFault)
{
    EscBench bench;
    const auto turned = [&](Instant at) { return static_cast<std::uint32_t>(at.count() / 50); }; // 20 a ms
    std::uint32_t offset = 0x1000;
    bench.position = [&](Instant at) {
        if (bench.has["S"] == "00800000" && offset == 0x1000)
            offset = 0x800000 - turned(at);
        return turned(at) + offset;
    };
    bench.settle();
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x800000});
    EXPECT_TRUE(outcome.result);
    EXPECT_GE(outcome.positionAfter, 0x800000);
}

TEST(EscPreset, AcceptedAndNotThereIsNotBelieved)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("GP", "");
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x800000});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(outcome.positionAfter, 0x1235);
}

// CR LF came, and nothing else happened: 1300h is close enough for the shaft to have turned there.
TEST(EscPreset, AcceptedWithThePresetValueAsItWasIsNotDone)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("GP", "");
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1300});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error(), (Refusal{RefusalKind::device,
                                               RefusalId::verificationFailed,
                                               {Parameter::preset, std::int64_t{0x1300}, std::int64_t{1}}}));
}

// S is still the preset from last time, and the shaft has turned since: 1235h is close enough to 1300h.
TEST(EscPreset, AcceptedWithThePresetValueOfTheLastTimeThePositionDecides)
{
    EscBench bench;
    bench.has["S"] = "00001300";
    bench.settle();
    bench.answerNext("GP", "");
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1300});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(outcome.positionAfter, 0x1235);
    EXPECT_TRUE(bench.finish(SetPreset{.value = 0x1300}).result);
    EXPECT_TRUE(bench.finish(SetPreset{.value = 0x1300}).result) << "it is there, and was before";
}

// 20 steps per ms: the encoder kept turning as if there had been no command.
TEST(EscPreset, AcceptedByATurningShaftThatGoesOnIsNotDone)
{
    EscBench bench;
    bench.has["S"] = "00001300";
    bench.position = [](Instant at) { return static_cast<std::uint32_t>(0x10000 + at.count() / 50); };
    bench.settle();
    bench.answerNext("GP", "");
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1300});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, RefusalId::verificationFailed);
}

// From the command on the shaft turns, 20 steps per ms: whether from 1235h or from 1300h cannot be told.
void beginToTurnWithTheCommand(EscBench &bench)
{
    const auto begun = std::make_shared<std::optional<Instant>>();
    bench.position = [&bench, begun](Instant at) {
        if (!*begun && bench.count("GP") > 0)
            *begun = at;
        return static_cast<std::uint32_t>(0x1235 + (at - begun->value_or(at)).count() / 50);
    };
}

TEST(EscPreset, AcceptedWithoutProofIsNotKnown)
{
    EscBench bench;
    bench.settle();
    bench.always("S", Fate::lost);
    beginToTurnWithTheCommand(bench);
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1300});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error(), (Refusal{RefusalKind::device,
                                               EscRefusalId::presetUnproven,
                                               {QStringLiteral("03GP00001300"), std::int64_t{0x1300}}}));
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscPreset, AJumpNoShaftCanMakeIsProofWithoutThePresetValue)
{
    EscBench bench;
    bench.settle();
    bench.always("S", Fate::lost);
    EXPECT_TRUE(bench.finish(SetPreset{.value = 0x800000}).result);
}

// S was not known before, so it says nothing about a command without an answer.
TEST(EscPreset, ThePresetValueProvesNothingWhereItWasNotReadBefore)
{
    EscBench bench;
    bench.settle();
    bench.next("S", Fate::lost);
    bench.has["S"] = "00001300";
    bench.next("GP", Fate::lost);
    beginToTurnWithTheCommand(bench);
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1300});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeUnknown);
}

TEST(EscPreset, WithoutAnAnswerItIsFoundDoneAndNeverRepeated)
{
    EscBench bench;
    bench.settle();
    bench.next("GP", Fate::unanswered);
    const Outcome &outcome = bench.finish(SetPreset{.value = wanted});
    EXPECT_TRUE(outcome.result);
    EXPECT_EQ(bench.count("GP"), 1);
    EXPECT_EQ(outcome.positionAfter, wanted);
    EXPECT_EQ(outcome.eepromWrites, 1);
}

TEST(EscPreset, WithoutAnAnswerItIsFoundNotDone)
{
    for (const std::int64_t value : {wanted, std::int64_t{0x1800000}}) {
        EscBench bench;
        bench.settle();
        bench.next("GP", Fate::lost);
        const Outcome &outcome = bench.finish(SetPreset{.value = value});
        ASSERT_FALSE(outcome.result);
        EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeNotDone) << value;
        EXPECT_EQ(bench.count("GP"), 1);
        EXPECT_EQ(outcome.positionAfter, 0x1235);
        EXPECT_EQ(outcome.eepromWrites, 0);
    }
}

// Position and preset value were already the wanted ones: the cases cannot be told apart.
TEST(EscPreset, WithoutAnAnswerItMayStayUnknown)
{
    EscBench bench;
    bench.has["S"] = "00001235";
    bench.settle();
    bench.next("GP", Fate::lost);
    const Outcome &outcome = bench.finish(SetPreset{.value = 0x1235});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::writeUnknown);
    EXPECT_EQ(outcome.result.error().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("03GP00001235")}));
    EXPECT_EQ(bench.count("GP"), 1);
}

TEST(EscPreset, WhatContradictsItselfIsUnknown)
{
    EscBench bench;
    bench.settle();
    bench.next("GP", Fate::lost);
    ASSERT_TRUE(bench.begin(SetPreset{.value = 0x800000}));
    bench.runUntil([&] { return bench.count("GP") == 1; });
    bench.has["S"] = "00800000"; // says that the preset was taken, but the position did not move
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::writeUnknown);
}

TEST(EscPreset, SilenceAfterwardsLeavesItUnknown)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(SetPreset{.value = wanted}));
    bench.next("GP", Fate::unanswered);
    bench.runUntil([&] { return bench.count("GP") == 1; });
    bench.isOn = false;
    bench.runUntil([&] { return bench.outcome.has_value(); });
    ASSERT_FALSE(bench.outcome->result);
    EXPECT_EQ(bench.outcome->result.error().id, EscRefusalId::writeUnknown);
    EXPECT_EQ(bench.outcome->eepromWrites, 1);
    EXPECT_EQ(bench.value(Parameter::preset), std::nullopt);
}

TEST(EscPreset, ByHandTheCommandWaits)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(SetPreset{.value = wanted}, Pace::byHand));
    bench.run(std::chrono::seconds(1));
    EXPECT_TRUE(bench.progress.waitsForUser);
    EXPECT_EQ(bench.progress.steps.at(static_cast<std::size_t>(bench.progress.index)).line, "03GP00005200");
    EXPECT_EQ(bench.count("GP"), 0);
    bench.driver.proceed();
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_TRUE(bench.outcome->result);
}

TEST(EscPreset, IsRefused)
{
    EscBench bench;
    bench.settle();
    bench.answerNext("GP", "05");
    const Outcome &outcome = bench.finish(SetPreset{.value = wanted});
    ASSERT_FALSE(outcome.result);
    EXPECT_EQ(outcome.result.error().id, EscRefusalId::outOfRange);
    EXPECT_EQ(outcome.eepromWrites, 0);
}

} // namespace
} // namespace codewheel
