// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/simulated_position_encoder.h"

#include <random>

namespace codewheel {
namespace {

constexpr PhysicalResolution twelveBit{4096, 1};
constexpr PhysicalResolution thirteenBit{8192, 1};
constexpr PhysicalResolution twelvePlusTwelveBit{4096, 4096};

struct Row
{
    PhysicalResolution resolution;
    std::int64_t raw;
    const char *in;
};

// FRABA manual 2.1.1 and 2.1.2: binary, right-aligned, zeros above
TEST(PositionEncoder, ShowsItsRawPosition)
{
    const Row rows[] = {
        {twelveBit, 0, "00000000"},
        {twelveBit, 4095, "00000FFF"},
        {twelveBit, 4096, "00000000"}, // one turn on
        {thirteenBit, 8191, "00001FFF"},
        {twelvePlusTwelveBit, 4096, "00001000"},
        {twelvePlusTwelveBit, 16'777'215, "00FFFFFF"},
        {twelvePlusTwelveBit, 16'777'216, "00000000"},
        {twelvePlusTwelveBit, -1, "00FFFFFF"},
        {thirteenPlusTwelve, 33'554'431, "01FFFFFF"},
    };
    for (const Row &row : rows) {
        SimulatedPositionEncoder encoder(row.resolution, row.raw);
        EXPECT_EQ(hex8(encoder.cycle(0)), row.in);
        encoder.turnTo(0);
        encoder.turnBy(row.raw);
        EXPECT_EQ(hex8(encoder.cycle(0)), row.in);
    }
}

TEST(PositionEncoder, TurnsWithItsShaft)
{
    SimulatedPositionEncoder encoder(twelveBit, 0);
    encoder.setSpeed(60); // a turn a second
    for (int i = 0; i < 250; ++i)
        encoder.cycle(0);
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000400"); // a quarter
    for (int i = 0; i < 749; ++i)
        encoder.cycle(0);
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000000");
    EXPECT_EQ(encoder.shaftState()->revolutionsPerMinute, 60);
}

TEST(PositionEncoder, HasNothingToSetUp)
{
    SimulatedPositionEncoder encoder(twelveBit, 100);
    encoder.setSlow(true);
    encoder.loseParameters();
    encoder.setBatteryLow(true);
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000064");
    const auto shaft = encoder.shaftState();
    ASSERT_TRUE(shaft);
    EXPECT_FALSE(shaft->hasParameters || shaft->slow || shaft->hasBattery || shaft->batteryLow);
    EXPECT_EQ(shaft->eepromWrites, 0);
    EXPECT_FALSE(encoder.rodState());
}

TEST(PositionEncoder, ShowsZeroWithoutPower)
{
    SimulatedPositionEncoder encoder(twelveBit, 100);
    encoder.setPower(false);
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000000");
    EXPECT_FALSE(encoder.shaftState()->powered);
    encoder.turnBy(1); // an absolute encoder notices all the same
    encoder.setPower(true);
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000065");

    encoder.powerCycle();
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(hex8(encoder.cycle(0)), "00000000") << i;
    EXPECT_EQ(hex8(encoder.cycle(0)), "00000065");
    EXPECT_TRUE(encoder.shaftState()->powered);
}

// A K4 has an OUT word, and no source says what it does.
TEST(PositionEncoder, TakesNoNoticeOfAMillionWords)
{
    SimulatedPositionEncoder encoder(twelvePlusTwelveBit, 76'367);
    std::mt19937 random(71);
    for (int i = 0; i < 1'000'000; ++i)
        ASSERT_EQ(encoder.cycle(static_cast<Word>(random())), 0x0001'2A4FU) << i;
}

} // namespace
} // namespace codewheel
