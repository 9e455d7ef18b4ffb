// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/circle.h"
#include "vocabulary/position_speed.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr std::int64_t stepsOfTurn = 8192;
constexpr PositionSpeed::Scale multiTurn{.stepsPerTurn = stepsOfTurn, .total = stepsOfTurn * 4096};
constexpr PositionSpeed::Scale singleTurn{.stepsPerTurn = stepsOfTurn, .total = stepsOfTurn};

// A shaft of known speed, seen at irregular times.
class PositionSpeedTest : public testing::Test
{
protected:
    void scale(const PositionSpeed::Scale &newScale)
    {
        m_scale = newScale;
        speed.setScale(newScale);
    }

    // What it reads after each position, in tenths of a revolution per minute; nothing: no speed.
    std::set<std::optional<long>> turn(double rpm, Instant duration, Instant shortest, Instant longest)
    {
        std::set<std::optional<long>> readings;
        std::uniform_int_distribution<std::int64_t> gap(shortest / 1ms, longest / 1ms);
        for (const Instant end = now + duration; now < end;) {
            const Instant step = gap(m_random) * 1ms;
            now += step;
            m_turns += rpm / 60 * std::chrono::duration<double>(step).count();
            readings.insert(seen());
        }
        return readings;
    }
    void jump(double turns) { m_turns += turns; }

    PositionSpeed speed;
    Instant now{};

private:
    std::optional<long> seen()
    {
        const auto position = static_cast<std::int64_t>(std::floor(m_turns * m_scale.stepsPerTurn + 1e-6));
        const auto read = speed.after(modulo(position, m_scale.total.value_or(1LL << 40)), now);
        return read ? std::optional(std::lround(*read / m_scale.stepsPerTurn * 600)) : std::nullopt;
    }

    PositionSpeed::Scale m_scale;
    double m_turns = 17;
    std::mt19937 m_random{4711};
};

using Tenths = std::set<std::optional<long>>;

TEST_F(PositionSpeedTest, SixtyTurnsAMinuteAreSixtyThoughCyclesAreMissed)
{
    scale(multiTurn);
    turn(60, 700ms, 1ms, 9ms);
    EXPECT_EQ(turn(60, 5s, 1ms, 9ms), Tenths{600});
    turn(-60, 700ms, 1ms, 9ms);
    EXPECT_EQ(turn(-60, 5s, 1ms, 9ms), Tenths{-600});
}

TEST_F(PositionSpeedTest, TheEndOfTheRangeIsNoSpeed)
{
    scale(singleTurn);
    turn(60, 700ms, 1ms, 1ms);
    EXPECT_EQ(turn(60, 5s, 1ms, 1ms), Tenths{600}) << "five turns over the end";
    scale({.stepsPerTurn = stepsOfTurn, .total = stepsOfTurn * 16});
    turn(-60, 700ms, 1ms, 30ms);
    EXPECT_EQ(turn(-60, 40s, 1ms, 30ms), Tenths{-600});
}

TEST_F(PositionSpeedTest, ASlowShaftWithFewStepsIsWatchedForLonger)
{
    scale({.stepsPerTurn = 360, .total = 360 * 4096});
    turn(0.5, 3s, 1ms, 3ms);
    EXPECT_EQ(turn(0.5, 30s, 1ms, 3ms), Tenths{5});
}

TEST_F(PositionSpeedTest, AFastShaftOfOneTurnIsReadWhereEachCycleIsSeen)
{
    scale(singleTurn);
    turn(6000, 700ms, 1ms, 1ms);
    EXPECT_EQ(turn(6000, 2s, 1ms, 1ms), Tenths{60'000});
}

TEST_F(PositionSpeedTest, WhereATurnMayHaveBeenMissedThereIsNoSpeed)
{
    scale(singleTurn);
    EXPECT_EQ(turn(6000, 3s, 5ms, 30ms), Tenths{std::nullopt});
    EXPECT_EQ(turn(5910, 3s, 10ms, 10ms), Tenths{std::nullopt}) << "it looks like -90";
    scale(multiTurn);
    turn(6000, 700ms, 5ms, 30ms);
    EXPECT_EQ(turn(6000, 2s, 5ms, 30ms), Tenths{60'000});
}

// At 12000 rpm, the fastest that the manuals allow, an encoder makes four fifths of a turn in 4 ms: less than
// a fifth of a turn the other way cannot be that.
TEST_F(PositionSpeedTest, AShaftOfOneTurnHasASpeedWhereNoOtherIsPossible)
{
    scale({.stepsPerTurn = 4096, .total = 4096});
    for (const double rpm : {0.0, 60.0, -1'500.0, 2'900.0}) {
        turn(rpm, 2s, 4ms, 4ms);
        EXPECT_EQ(turn(rpm, 2s, 4ms, 4ms), Tenths{std::lround(10 * rpm)});
        EXPECT_FALSE(speed.mayMissTurns());
        speed.restart();
    }
    EXPECT_EQ(turn(3'600, 2s, 4ms, 4ms), Tenths{std::nullopt}) << "or it turns at 11400 the other way";
    EXPECT_TRUE(speed.mayMissTurns());
    speed.restart();
    EXPECT_EQ(turn(60, 2s, 20ms, 20ms), Tenths{std::nullopt});
    EXPECT_TRUE(speed.mayMissTurns());
    EXPECT_FALSE(speed.after({}, now)) << "no position";
    EXPECT_FALSE(speed.mayMissTurns());
}

TEST_F(PositionSpeedTest, APresetIsNoSpeed)
{
    scale(multiTurn);
    for (const double turns : {100.0, -3.0, 0.5, 0.1}) {
        turn(60, 700ms, 1ms, 2ms);
        jump(turns);
        EXPECT_EQ(turn(60, 2s, 1ms, 2ms), (Tenths{std::nullopt, 600})) << turns;
    }
}

TEST_F(PositionSpeedTest, AGapIsNoSpeed)
{
    scale(multiTurn);
    turn(60, 700ms, 1ms, 2ms);
    now += 3s;
    jump(3);
    EXPECT_EQ(turn(60, 50ms, 1ms, 2ms), Tenths{std::nullopt});
    EXPECT_EQ(turn(60, 2s, 1ms, 2ms), (Tenths{std::nullopt, 600}));
}

TEST_F(PositionSpeedTest, AStandingShaftHasSpeedZeroOnceThatIsSure)
{
    scale(multiTurn);
    EXPECT_EQ(turn(0, 400ms, 1ms, 2ms), Tenths{std::nullopt});
    turn(0, 200ms, 1ms, 2ms);
    EXPECT_EQ(turn(0, 2s, 1ms, 2ms), Tenths{0});
}

TEST_F(PositionSpeedTest, AShaftThatStopsIsSoonAtZeroAndStartsAnew)
{
    scale(multiTurn);
    turn(60, 2s, 1ms, 2ms);
    turn(0, 200ms, 1ms, 2ms);
    EXPECT_EQ(turn(0, 10s, 1ms, 2ms), Tenths{0});
    turn(60, 700ms, 1ms, 2ms);
    EXPECT_EQ(turn(60, 2s, 1ms, 2ms), Tenths{600});
}

TEST_F(PositionSpeedTest, AnswersOfALineComeAsTheyCome)
{
    scale(multiTurn);
    turn(60, 700ms, 7ms, 45ms);
    EXPECT_EQ(turn(60, 5s, 7ms, 45ms), Tenths{600});
    turn(60, 2s, 300ms, 600ms);
    EXPECT_EQ(turn(60, 20s, 300ms, 600ms), Tenths{600});
}

TEST_F(PositionSpeedTest, WithoutItsScaleThereIsNoSpeed)
{
    EXPECT_EQ(speed.after(5, 0ms), std::nullopt);
    EXPECT_EQ(speed.after(5, 2s), std::nullopt);
}

} // namespace
} // namespace codewheel
