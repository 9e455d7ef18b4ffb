// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/driver/esc_bench.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Lines = std::vector<std::string>;

WriteParameters limits()
{
    return {.values = {{Parameter::lowerLimit, 0x200}, {Parameter::upperLimit, 0x300}}, .previous = {}};
}

TEST(EscCancel, WhatWasWrittenIsReadBackAndTheRestLeftOut)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(limits()));
    bench.runUntil([&] { return bench.count("GL") == 1; });
    bench.driver.cancel(OnCancel::runWithWhatItHas, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L", "03L"}));
    EXPECT_EQ(bench.outcome->written, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
    EXPECT_EQ(bench.value(Parameter::lowerLimit), 0x200);
    EXPECT_EQ(bench.outcome->eepromWrites, 1);
}

TEST(EscCancel, IfNothingWasTakenAJobThatHasWrittenGoesOn)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(limits()));
    const esc::Request request = bench.goOnTo(esc::Command::writeLowerLimit);
    bench.driver.cancel(OnCancel::ifNothingTaken, bench.now);
    bench.has["L"] = "00000200";
    bench.driver.answered(request, {.answer = {}, .sent = 1, .timeOuts = 1}, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_TRUE(bench.progress.hasTaken);
    EXPECT_TRUE(bench.outcome->result);
    EXPECT_EQ(bench.count("GH"), 1);
}

TEST(EscCancel, AWriteOnItsWayIsWaitedFor)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(limits()));
    const esc::Request request = bench.goOnTo(esc::Command::writeLowerLimit);
    bench.driver.cancel(OnCancel::leaveAsIs, bench.now);
    EXPECT_TRUE(bench.driver.busy());
    bench.has["L"] = "00000200";
    bench.driver.answered(request, {.answer = {}, .sent = 1, .timeOuts = 1}, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(bench.outcome->written, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
    EXPECT_EQ(bench.count("GH"), 0);
}

TEST(EscCancel, OldValuesGoBackWhereTheyAreKnown)
{
    EscBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::lowerLimit, Parameter::upperLimit}});
    bench.log.clear();
    ASSERT_TRUE(bench.begin(limits(), Pace::byHand));
    bench.runUntil([&] { return bench.progress.waitsForUser; });
    bench.driver.proceed();
    bench.runUntil([&] { return bench.progress.waitsForUser && bench.progress.index == 3; });
    EXPECT_TRUE(bench.progress.canRestore);
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200", "03L", "03L", "03GL00000100", "03L", "03L"}));
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(bench.outcome->eepromWrites, 2);
    EXPECT_EQ(bench.outcome->restored, Evidence::read);
    EXPECT_EQ(bench.value(Parameter::lowerLimit), 0x100);
}

TEST(EscCancel, AnOldValueThatReadsBackDifferentlyIsNotRestored)
{
    EscBench bench;
    bench.settle();
    bench.finish(ReadParameters{{Parameter::lowerLimit, Parameter::upperLimit}});
    ASSERT_TRUE(bench.begin(limits(), Pace::byHand));
    bench.runUntil([&] { return bench.progress.waitsForUser; });
    bench.driver.proceed();
    bench.runUntil([&] { return bench.progress.waitsForUser && bench.progress.index == 3; });
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    bench.runUntil([&] { return bench.count("GL") == 2; });
    bench.has["L"] = "00000200";
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::verificationFailed);
    EXPECT_EQ(bench.outcome->restored, std::nullopt);
}

TEST(EscCancel, OldStepsGoBackWithTheirRevolutions)
{
    EscBench bench;
    bench.has["U"] = "0010"; // 16
    bench.settle();
    bench.finish(ReadParameters{{Parameter::steps, Parameter::revolutions, Parameter::scalingFactor}});
    ASSERT_TRUE(
        bench.begin(WriteParameters{.values = {{Parameter::steps, 4096}}, .previous = {}}, Pace::byHand));
    bench.runUntil([&] { return bench.progress.waitsForUser; });
    bench.driver.proceed();
    bench.runUntil([&] { return bench.progress.waitsForUser && bench.count("GR") == 1; });
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.has["D"], "2000");
    EXPECT_EQ(bench.has["U"], "0010");
    EXPECT_EQ(bench.outcome->setAlong, ParameterValues());
}

TEST(EscCancel, BetweenTheScalingAndItsFactorTheEncoderIsRead)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(
        bench.begin(WriteParameters{.values = {{Parameter::steps, 4096}}, .previous = {}}, Pace::byHand));
    bench.runUntil([&] { return bench.progress.waitsForUser; });
    bench.driver.proceed();
    bench.runUntil([&] { return bench.progress.waitsForUser && bench.count("GR") == 1; });
    bench.driver.cancel(OnCancel::leaveAsIs, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.count("GF"), 0);
    EXPECT_EQ(bench.value(Parameter::steps), 4096);
    EXPECT_EQ(bench.value(Parameter::scalingFactor), 0x20000000);
    EXPECT_EQ(bench.outcome->written, (ParameterValues{{Parameter::steps, 4096}}));
}

TEST(EscCancel, BeforeAnythingIsSentItEndsAtOnce)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(limits(), Pace::byHand));
    bench.run(std::chrono::milliseconds(100));
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    EXPECT_FALSE(bench.driver.busy());
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(bench.jobLog(), Lines());
}

TEST(EscCancel, AnEncoderThatMovedIsStillLookedFor)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(WriteParameters{
        .values = {{Parameter::lineAddress, 7}, {Parameter::baudRate, 9600}}, .previous = {}}));
    bench.runUntil([&] { return bench.count("X") == 1; });
    bench.driver.cancel(OnCancel::leaveAsIs, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.driver.address(), EscLineAddress{7});
    EXPECT_EQ(bench.count("Y"), 0);
}

TEST(EscStop, EndsTheJobWhereItStands)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(limits()));
    bench.runUntil([&] { return bench.count("GL") == 1; });
    bench.driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, bench.now);
    EXPECT_FALSE(bench.driver.busy());
    bench.run(std::chrono::seconds(1));
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::alarmStop);
    EXPECT_EQ(bench.outcome->written, (ParameterValues{{Parameter::lowerLimit, 0x200}}));
    EXPECT_EQ(bench.jobLog(), (Lines{"03GL00000200"}));
    EXPECT_EQ(bench.eepromWrites, 1);
}

// Runs until the write has gone out, with its answer still to come.
esc::Request requestOfLowerLimit(EscBench &bench)
{
    bench.settle();
    bench.finish(ReadParameters{{Parameter::lowerLimit}});
    EXPECT_TRUE(bench.begin(limits()));
    return bench.goOnTo(esc::Command::writeLowerLimit);
}

TEST(EscStop, AWriteThatIsAnsweredAfterwardsCounts)
{
    EscBench bench;
    const esc::Request request = requestOfLowerLimit(bench);
    bench.driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, bench.now);
    bench.driver.answered(request, {.answer = esc::Answer{esc::Answer::Kind::accepted, 0, {}}, .sent = 1},
                          bench.now);
    bench.step();
    EXPECT_EQ(bench.eepromWrites, 1);
    EXPECT_EQ(bench.value(Parameter::lowerLimit), std::nullopt);
}

TEST(EscStop, SaysWhichWriteWasUnderWay)
{
    EscBench bench;
    requestOfLowerLimit(bench);
    bench.driver.stop({RefusalKind::link, RefusalId::portLost, {QStringLiteral("/dev/ttyUSB0")}}, bench.now);
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->result.error(),
              (Refusal{RefusalKind::link, RefusalId::stoppedInWrite, {QStringLiteral("03GL00000200")}}));
    EXPECT_EQ(bench.value(Parameter::lowerLimit), std::nullopt);
    EXPECT_EQ(bench.outcome->eepromWrites, 1) << "it may have been carried out";
}

TEST(EscStop, AWriteThatIsRefusedAfterwardsIsNotCountedOfTheEncoder)
{
    EscBench bench;
    const esc::Request request = requestOfLowerLimit(bench);
    bench.driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, bench.now);
    bench.driver.answered(request, {.answer = esc::Answer{esc::Answer::Kind::outOfRange, 0, {}}, .sent = 1},
                          bench.now);
    bench.step();
    EXPECT_EQ(bench.eepromWrites, 0);
}

TEST(EscStop, AWriteWithoutAnAnswerMayHaveBeenCarriedOut)
{
    EscBench bench;
    const esc::Request request = requestOfLowerLimit(bench);
    bench.driver.answered(request, {.answer = {}, .sent = 1, .timeOuts = 1}, bench.now);
    bench.driver.stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, bench.now);
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->result.error().id, RefusalId::stoppedInWrite);
    EXPECT_EQ(bench.outcome->eepromWrites, 1);
    EXPECT_EQ(bench.eepromWrites, 1);
}

TEST(EscStop, BetweenWritesSaysWhatEndedIt)
{
    EscBench bench;
    bench.settle();
    ASSERT_TRUE(bench.begin(ReadParameters{{Parameter::lowerLimit}}));
    const Refusal lost{RefusalKind::link, RefusalId::portLost, {QStringLiteral("/dev/ttyUSB0")}};
    bench.driver.stop(lost, bench.now);
    bench.step();
    ASSERT_TRUE(bench.outcome);
    EXPECT_EQ(bench.outcome->result.error(), lost);
}

// Cancelled between every two requests, and before the first.
TEST(EscCancel, NothingIsWrittenAfterIt)
{
    const std::pair<const char *, Job> jobs[] = {
        {"read", ReadParameters{{Parameter::steps, Parameter::preset}}},
        {"limits", limits()},
        {"steps", WriteParameters{.values = {{Parameter::steps, 0x360}}, .previous = {}}},
        {"what differs", WriteParameters{.values = {{Parameter::lowerLimit, 0x200}},
                                         .onlyWhatDiffers = true,
                                         .previous = {}}},
        {"address", WriteParameters{.values = {{Parameter::lineAddress, 9}}, .previous = {}}},
        {"preset", SetPreset{.value = 5}},
    };
    const auto writes = [](const EscBench &bench) {
        return std::ranges::count_if(bench.log,
                                     [](const std::string &line) { return lettersOf(line)[0] == 'G'; });
    };
    for (const auto &[name, job] : jobs)
        for (int k = 0; k < 40 && !testing::Test::HasFailure(); ++k) {
            SCOPED_TRACE(name + std::string(", request ") + std::to_string(k));
            EscBench bench;
            bench.settle();
            ASSERT_TRUE(bench.begin(job));
            for (int i = 0; i < k && !bench.outcome; ++i)
                bench.step();
            if (bench.outcome)
                break;
            const auto before = writes(bench);
            bench.driver.cancel(OnCancel::leaveAsIs, bench.now);
            bench.runUntil([&] { return bench.outcome.has_value(); });
            bench.run(std::chrono::seconds(2));
            ASSERT_FALSE(bench.outcome->result);
            EXPECT_EQ(bench.outcome->result.error().id, RefusalId::cancelled);
            EXPECT_EQ(writes(bench), before);
        }
}

// The steps set as many revolutions as it had, so these are not sent; the factor need not follow from them.
TEST(EscCancel, OldStepsGoBackWithTheirFactorAndNothingElse)
{
    EscBench bench;
    bench.has["F"] = "10000000";
    bench.settle();
    bench.finish(ReadParameters{{Parameter::steps, Parameter::revolutions, Parameter::scalingFactor}});
    ASSERT_EQ(bench.value(Parameter::revolutions), 4096);
    ASSERT_TRUE(
        bench.begin(WriteParameters{.values = {{Parameter::steps, 4096}}, .previous = {}}, Pace::byHand));
    bench.runUntil([&] { return bench.progress.waitsForUser; });
    bench.driver.proceed();
    bench.runUntil([&] { return bench.progress.waitsForUser && bench.count("GR") == 1; });
    bench.driver.cancel(OnCancel::restorePrevious, bench.now);
    bench.runUntil([&] { return bench.outcome.has_value(); });
    EXPECT_EQ(bench.count("GM"), 0);
    EXPECT_EQ(bench.count("GR"), 2);
    EXPECT_TRUE(std::ranges::count(bench.log, "03GF10000000"));
    EXPECT_EQ(bench.outcome->restored, Evidence::read);
}

} // namespace
} // namespace codewheel
