// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/simulator/node_bench.h"

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;
using NodePosition = NodeBench;

const CanopenEncoderPlan turningNode{.node = 5, .raw = 8192};

TEST_F(NodePosition, IsScaledWhileScalingIsOn)
{
    add(turningNode);
    EXPECT_EQ(write("23", "6001", "68 01 00 00"), "");
    EXPECT_EQ(write("23", "6002", "D0 02 00 00"), ""); // two turns of 360
    EXPECT_EQ(number("6004"), 8192);
    EXPECT_EQ(write("2B", "6000", "04 00"), "");
    EXPECT_EQ(number("6004"), 360);
    EXPECT_EQ(read("6500"), "04 00");
    node().shaft().turnTo(2 * 8192 + 4096);
    EXPECT_EQ(number("6004"), 180);
}

TEST_F(NodePosition, ThePresetMovesItByTheOffset)
{
    add(turningNode);
    EXPECT_EQ(write("23", "6003", "10 00 00 00"), "");
    EXPECT_EQ(number("6004"), 16);
    EXPECT_EQ(read("6509"), "10 E0 FF FF"); // 16 - 8192
    node().shaft().turnTo(0);
    EXPECT_EQ(number("6004"), 33'554'432 - 8176);
}

TEST_F(NodePosition, CountsDownCounterClockwise)
{
    add(turningNode);
    write("2B", "6000", "01 00");
    EXPECT_EQ(number("6004"), 33'554'431 - 8192);
    node().shaft().turnBy(1);
    EXPECT_EQ(number("6004"), 33'554'431 - 8193);
}

TEST_F(NodePosition, SpeedIsInRevolutionsPerMinute)
{
    add(turningNode);
    node().shaft().setSpeed(-30);
    EXPECT_EQ(read("6030:1"), "E2 FF");
    write("2B", "6000", "01 00");
    EXPECT_EQ(read("6030:1"), "1E 00");
}

TEST_F(NodePosition, CamsHaveStatesHysteresisAndPolarity)
{
    add(turningNode);
    EXPECT_EQ(write("23", "6310:1", "64 00 00 00"), ""); // cam 1: 100 to 200
    EXPECT_EQ(write("23", "6320:1", "C8 00 00 00"), "");
    EXPECT_EQ(write("2B", "6330:1", "0A 00"), "");
    EXPECT_EQ(write("23", "6312:1", "96 00 00 00"), ""); // cam 3: 150 to 160
    EXPECT_EQ(write("23", "6322:1", "A0 00 00 00"), "");
    EXPECT_EQ(write("2F", "6301:1", "05"), "");
    const std::pair<int, const char *> rows[] = {{99, "00"},  {100, "01"}, {150, "05"}, {161, "01"},
                                                 {210, "01"}, {211, "00"}, {201, "00"}, {200, "01"},
                                                 {90, "01"},  {89, "00"}};
    for (const auto &[raw, states] : rows) {
        node().shaft().turnTo(raw);
        EXPECT_EQ(read("6300:1"), states) << raw;
    }
    EXPECT_EQ(write("2F", "6302:1", "03"), "");
    EXPECT_EQ(read("6300:1"), "01"); // cam 2 is not enabled
}

TEST_F(NodePosition, TheWorkAreaTellsWhereItWasLeft)
{
    add(turningNode);
    EXPECT_EQ(write("23", "6401:1", "64 00 00 00"), "");
    EXPECT_EQ(write("23", "6402:1", "C8 00 00 00"), "");
    const std::pair<int, const char *> rows[] = {{99, "05"}, {100, "00"}, {200, "00"}, {201, "03"}};
    for (const auto &[raw, state] : rows) {
        node().shaft().turnTo(raw);
        EXPECT_EQ(read("6400:1"), state) << raw;
    }
}

TEST_F(NodePosition, OfALinearEncoderGoesThereAndBack)
{
    add({.node = 5,
         .form = CanopenEncoderPlan::Form::linear,
         .resolution = {.stepsPerTurn = 8000, .turns = 50}, // there and back: 1 m in steps of 5 um
         .raw = 1000,
         .revolutionsPerMinute = 60}); // 40 mm/s
    EXPECT_EQ(read("1000"), "96 01 08 00");
    EXPECT_EQ(read("6501"), "88 13 00 00");
    EXPECT_EQ(read("6502"), "06020000");
    EXPECT_EQ(read("6030:1"), "A0 0F");
    node().shaft().setSpeed(0);
    node().shaft().turnTo(1000);
    EXPECT_EQ(number("6004"), 1000);
    node().shaft().turnTo(200'001);
    EXPECT_EQ(number("6004"), 199'998);
    EXPECT_EQ(write("23", "6005:1", "10 27 00 00"), ""); // 10 um
    EXPECT_EQ(number("6004"), 99'999);
    EXPECT_EQ(write("23", "6003", "FB FF FF FF"), "");
    EXPECT_EQ(read("6004"), "FB FF FF FF"); // -5
    EXPECT_EQ(write("2B", "6000", "08 00"), "");
    EXPECT_EQ(write("23", "6003", "00 00 00 00"), "");
    node().shaft().turnBy(2);
    EXPECT_EQ(read("6004"), "01 00 00 00");
}

} // namespace
} // namespace codewheel::canopen
