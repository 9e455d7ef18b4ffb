// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/simulator/node_bench.h"

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;
using NodePdo = NodeBench;

const CanopenEncoderPlan pdoNode{.node = 5, .raw = 5'000};

TEST_F(NodePdo, TimerAndInhibitTimeHold)
{
    add(pdoNode);
    write("2B", "1800:5", "32 00");
    EXPECT_EQ(read("6200"), "32 00");
    write("2B", "6200", "64 00");
    EXPECT_EQ(read("1800:5"), "64 00");
    send("000#01 05");
    EXPECT_EQ(pass(1s).size(), 10U);
    node().shaft().setSpeed(60); // a step every 122 us
    EXPECT_NEAR(static_cast<double>(pass(1s).size()), 100, 1);
}

TEST_F(NodePdo, AtSyncTheSecondOneComes)
{
    add(pdoNode);
    EXPECT_EQ(send("080#"), Frames{});
    send("000#01 05");
    EXPECT_EQ(send("080#"), Frames{"285#88 13 00 00 00 00"});
    write("2F", "1801:2", "03");
    EXPECT_EQ(send("080#"), Frames{});
    EXPECT_EQ(send("080#"), Frames{});
    EXPECT_EQ(send("080#"), Frames{"285#88 13 00 00 00 00"});
    write("2F", "1801:2", "00"); // only after a change
    EXPECT_EQ(send("080#"), Frames{});
    node().shaft().turnBy(1);
    EXPECT_EQ(pass(20ms), Frames{"185#89 13 00 00"});
    EXPECT_EQ(send("080#"), Frames{"285#89 13 00 00 00 00"});
    EXPECT_EQ(send("285#R"), Frames{"285#89 13 00 00 00 00"});
}

TEST_F(NodePdo, IsMappedAnewWhileItIsOff)
{
    add(pdoNode);
    EXPECT_EQ(write("23", "1A00:1", "10 00 03 65"), "06010000");
    EXPECT_EQ(write("23", "1800:1", "85 01 00 80"), "");
    EXPECT_EQ(write("23", "1A00:1", "10 00 03 65"), "06010000"); // its count is not 0
    EXPECT_EQ(write("2F", "1A00", "00"), "");
    EXPECT_EQ(write("23", "1A00:1", "10 00 03 65"), "");
    EXPECT_EQ(write("23", "1A00:2", "20 00 04 60"), "");
    EXPECT_EQ(write("23", "1A00:3", "10 00 04 60"), "06040041"); // it has 32 bits
    EXPECT_EQ(write("23", "1A00:3", "20 00 01 60"), "06040041");
    EXPECT_EQ(write("2F", "1A00", "03"), "06040041"); // the third is none
    EXPECT_EQ(write("2F", "1A00", "09"), "06090031");
    EXPECT_EQ(write("23", "1A00:3", "20 00 04 60"), "");
    EXPECT_EQ(write("2F", "1A00", "03"), "06040042"); // 80 bits
    EXPECT_EQ(write("2F", "1A00", "02"), "");
    EXPECT_EQ(write("23", "1800:1", "90 01 00 40"), ""); // 190h
    EXPECT_EQ(send("000#01 05"), Frames{"190#00 00 88 13 00 00"});
    EXPECT_EQ(send("190#R"), Frames{}); // b30: no remote frames
}

TEST_F(NodePdo, OffThereIsNone)
{
    add(pdoNode);
    write("23", "1800:1", "85 01 00 80");
    EXPECT_EQ(send("000#01 05"), Frames{});
    EXPECT_EQ(send("605#23 00 18 01 85 01 00 00"),
              (Frames{"185#88 13 00 00", "585#60 00 18 01 00 00 00 00"}));
    EXPECT_EQ(pass(20ms), Frames{});
    node().shaft().turnBy(1);
    EXPECT_EQ(pass(20ms), Frames{"185#89 13 00 00"});
}

} // namespace
} // namespace codewheel::canopen
