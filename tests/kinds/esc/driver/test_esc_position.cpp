// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_messages.h"
#include "tests/kinds/esc/driver/esc_bench.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Verdict = EscPositionGuard::Verdict;
using Figures = EscPositionGuard::Figures;

// 60 turns of 100 steps per minute: 100 steps per second.
constexpr EscPositionGuard::Scale slow{.topSpeed = 60, .stepsPerTurn = 100, .total = 1000};

TEST(EscPositionGuard, ReachesWhatTheTopSpeedAllows)
{
    EscPositionGuard guard;
    guard.setScale(slow);
    EXPECT_TRUE(guard.canReach(100, 201, 1s)); // 100 steps, and one for the rounding of both
    EXPECT_FALSE(guard.canReach(100, 202, 1s));
    EXPECT_TRUE(guard.canReach(201, 100, 1s));
    EXPECT_TRUE(guard.canReach(950, 40, 1s)) << "over the end of the range";
    EXPECT_FALSE(guard.canReach(950, 40, 500ms));
    EXPECT_TRUE(guard.canReach(1000, 1, 0s)) << "the position after the last";
    guard.setScale({.topSpeed = 60, .stepsPerTurn = 100});
    EXPECT_FALSE(guard.canReach(950, 40, 1s)) << "the end is not known";
}

TEST(EscPositionGuard, TheNextAnswerConfirmsOrRefutes)
{
    struct Row
    {
        const char *what;
        std::vector<std::pair<std::int64_t, Verdict>> positions; // one each 10 ms
        Figures figures;
    };
    constexpr auto taken = Verdict::taken;
    constexpr auto suspect = Verdict::suspect;
    const Row rows[] = {
        {"standing", {{5, taken}, {5, taken}, {6, taken}}, {0, 0, 0}},
        {"one damaged digit", {{5, taken}, {0x8005, suspect}, {6, taken}, {6, taken}}, {1, 0, 1}},
        {"a jump that is real", {{5, taken}, {500, suspect}, {501, taken}, {502, taken}}, {1, 1, 0}},
        {"two damaged digits", {{5, taken}, {800, suspect}, {500, suspect}, {7, taken}}, {2, 0, 1}},
        {"beyond the disc", {{33'554'433, suspect}, {33, taken}}, {1, 0, 0}},
    };
    for (const Row &row : rows) {
        EscPositionGuard guard;
        guard.setScale(slow);
        Instant now{};
        for (const auto &[position, verdict] : row.positions)
            EXPECT_EQ(guard.judge(position, now += 10ms), verdict) << row.what << ' ' << position;
        EXPECT_EQ(guard.figures(), row.figures) << row.what;
    }
}

TEST(EscPositionGuard, AnyPositionIsTakenAfterItWasForgotten)
{
    EscPositionGuard guard;
    guard.setScale(slow);
    guard.judge(5, 0s);
    guard.forget();
    EXPECT_EQ(guard.judge(700, 10ms), Verdict::taken);
    EXPECT_EQ(guard.figures().suspect, 0);
}

TEST(EscPosition, ASuspectOneIsAskedForAgainAtOnceAndNotShown)
{
    EscBench bench({.positionInterval = 200ms});
    bench.settle();
    bench.runUntil([&] { return !bench.log.empty() && lettersOf(bench.log.back()) == "P"; });
    bench.answerNext("P", "00801235");
    bench.runUntil([&] { return bench.driver.reading().suspect; });
    EXPECT_EQ(bench.driver.reading().position, 0x1235);
    const Instant asked = bench.times.back();
    bench.run(60ms);
    EXPECT_EQ(bench.log.back(), "03P");
    EXPECT_LE(bench.times.back() - asked, 25ms);
    EXPECT_FALSE(bench.driver.reading().suspect);
    EXPECT_EQ(bench.driver.reading().position, 0x1235);
    EXPECT_EQ(bench.driver.figures(), (Figures{1, 0, 1}));
    ASSERT_EQ(bench.countOf(EscMessageId::suspectPosition), 1);
    EXPECT_EQ(bench.messages.back().arguments,
              (std::vector<RefusalArgument>{std::int64_t{0x801235}, std::int64_t{0x1235}}));
}

TEST(EscPosition, AJumpThatTheSecondAnswerConfirmsIsTaken)
{
    EscBench bench;
    bench.settle();
    bench.has["P"] = "00801235"; // the SET input, say
    bench.run(50ms);
    EXPECT_EQ(bench.driver.reading().position, 0x801235);
    EXPECT_EQ(bench.driver.figures(), (Figures{1, 1, 0}));
}

TEST(EscPosition, MessagesOfSuspectPositionsAreFew)
{
    EscBench bench;
    bench.settle();
    for (int i = 0; i < 20; ++i) {
        bench.answerNext("P", "00801235");
        bench.run(250ms);
    }
    EXPECT_EQ(bench.driver.figures(), (Figures{20, 0, 20}));
    EXPECT_EQ(bench.countOf(EscMessageId::suspectPosition), 1);
    bench.run(10s);
    bench.answerNext("P", "00801235");
    bench.run(100ms);
    EXPECT_EQ(bench.countOf(EscMessageId::suspectPosition), 2);
}

// 6000 revolutions per minute of 8192 steps: 8 438 steps in 10.3 ms.
TEST(EscPosition, TheTopSpeedIsSettableAndCountsInStepsOfTheEncoder)
{
    EscBench bench;
    bench.settle();
    bench.has["P"] = "00003235"; // 8192 steps further
    bench.run(50ms);
    EXPECT_EQ(bench.driver.figures().suspect, 0);
    EscSettings slower = bench.driver.settings();
    slower.topSpeed = 600;
    bench.driver.setSettings(slower);
    bench.has["P"] = "00001235";
    bench.run(50ms);
    EXPECT_EQ(bench.driver.figures().suspect, 1);

    bench.driver.setSettings({});
    bench.has["D"] = "0168"; // 360 steps: the same distance is now 22 turns
    bench.finish(ReadParameters{{Parameter::steps, Parameter::scaling}});
    bench.has["P"] = "00003235";
    bench.run(50ms);
    EXPECT_EQ(bench.driver.figures().suspect, 2);
}

TEST(EscPosition, GoesOverTheEndOfTheMeasuringRangeItKnows)
{
    EscBench bench;
    bench.has["O"] = "2004"; // scaling on
    bench.has["M"] = "00100000";
    bench.has["P"] = "000FFFF0";
    bench.settle();
    bench.finish(ReadParameters{{Parameter::measuringRange, Parameter::scaling}});
    bench.has["P"] = "00000010";
    bench.run(100ms);
    EXPECT_EQ(bench.driver.reading().position, 0x10);
    EXPECT_EQ(bench.driver.figures().suspect, 0);
}

// Manual, GS: with scaling disabled its own 8192 steps x 4096 turns count, whatever measuring range it keeps.
TEST(EscPosition, GoesOverTheEndOfItsCodeDiscWhileScalingIsOff)
{
    EscBench bench;
    bench.has["O"] = "2000";
    bench.has["M"] = "00100000";
    bench.has["P"] = "01FFFFF0";
    bench.settle();
    bench.finish(ReadParameters{{Parameter::measuringRange, Parameter::scaling}});
    bench.has["P"] = "00000010";
    bench.run(100ms);
    EXPECT_EQ(bench.driver.reading().position, 0x10);
    EXPECT_EQ(bench.driver.figures().suspect, 0);
}

} // namespace
} // namespace codewheel
