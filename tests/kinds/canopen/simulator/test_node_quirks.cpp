// SPDX-License-Identifier: GPL-3.0-or-later
// What is stored, and what makers do otherwise.
#include "tests/kinds/canopen/simulator/node_bench.h"

#include <algorithm>
#include <iterator>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;
using NodeStore = NodeBench;
using NodeQuirk = NodeBench;

constexpr const char *saveOctets = "73 61 76 65";
constexpr const char *loadOctets = "6C 6F 61 64";

CanopenEncoderPlan quirky(const NodeQuirks &quirks)
{
    return {.node = 5, .raw = 5'000, .quirks = quirks};
}

TEST_F(NodeStore, WhatIsNotStoredIsLostWithoutPower)
{
    add(quirky({}));
    write("23", "6003", "10 00 00 00");
    powerCycle();
    EXPECT_EQ(read("6004"), "88 13 00 00");
    write("23", "6003", "10 00 00 00");
    write("23", "6001", "68 01 00 00");
    EXPECT_EQ(write("23", "1010:1", saveOctets), "");
    EXPECT_EQ(node().eepromWrites(), 1U);
    powerCycle();
    EXPECT_EQ(read("6004"), "10 00 00 00");
    EXPECT_EQ(read("6001"), "68 01 00 00");
}

TEST_F(NodeStore, TheFactoryValuesAreInForceAfterAReset)
{
    add(quirky({}));
    write("23", "6003", "10 00 00 00");
    write("23", "1010:1", saveOctets);
    EXPECT_EQ(write("23", "1011:1", loadOctets), "");
    EXPECT_EQ(node().eepromWrites(), 2U);
    EXPECT_EQ(read("6004"), "10 00 00 00");
    send("000#81 05");
    pass(60ms);
    EXPECT_EQ(read("6004"), "88 13 00 00");
}

TEST_F(NodeStore, ABrokenMemoryIsToldAsHardware)
{
    add(quirky({}));
    node().setEepromBroken(true);
    EXPECT_EQ(write("23", "1010:1", saveOctets), "06060000");
    EXPECT_EQ(write("23", "1011:1", loadOctets), "06060000");
    EXPECT_EQ(node().eepromWrites(), 0U);
}

TEST_F(NodeStore, OffItSaysNothingAndItsShaftTurns)
{
    add(quirky({}));
    node().setOn(false);
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), "");
    node().shaft().turnBy(8);
    node().setOn(true);
    pass(60ms);
    EXPECT_EQ(read("6004"), "90 13 00 00");
}

TEST_F(NodeQuirk, StoringWithSilence)
{
    add(quirky({.silenceWhileStoring = 400ms}));
    write("2B", "1017", "64 00");
    EXPECT_EQ(send("605#23 10 10 01 73 61 76 65"), Frames{});
    EXPECT_EQ(send("605#40 04 60 00 00 00 00 00"), Frames{});
    EXPECT_EQ(pass(395ms), Frames{});
    EXPECT_EQ(pass(3ms), Frames{"585#60 10 10 01 00 00 00 00"});
    EXPECT_EQ(pass(100ms), Frames{"705#7F"});
}

TEST_F(NodeQuirk, StartingByItself)
{
    add(quirky({.startsItself = true}));
    node().setOn(false);
    pass(1ms);
    node().setOn(true);
    EXPECT_EQ(pass(60ms), (Frames{"705#00", "185#88 13 00 00"}));
}

TEST_F(NodeQuirk, LssThatForgets)
{
    add(quirky({.lssForgets = true}));
    send("7E5#04 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#11 07 00 00 00 00 00 00"), "7E4#11 00 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#17 00 00 00 00 00 00 00"), "7E4#17 00 00 00 00 00 00 00");
    EXPECT_EQ(node().eepromWrites(), 0U);
    powerCycle();
    EXPECT_EQ(node().node(), 5);
    send("7E5#04 01 00 00 00 00 00 00");
    ask("7E5#11 07 00 00 00 00 00 00");
    EXPECT_EQ(write("23", "1010:1", saveOctets), "");
    powerCycle();
    EXPECT_EQ(node().node(), 7);
}

TEST_F(NodeQuirk, LssOnlyWhenStopped)
{
    add(quirky({.lssOnlyWhenStopped = true}));
    send("7E5#04 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5E 00 00 00 00 00 00 00"), "");
    send("000#02 05");
    send("7E5#04 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5E 00 00 00 00 00 00 00"), "7E4#5E 05 00 00 00 00 00 00");
}

TEST_F(NodeQuirk, SpeedThatIsSwitchedOff)
{
    add(quirky({.speedIsOff = true}));
    node().shaft().setSpeed(30);
    EXPECT_EQ(read("6030:1"), "00 00");
    EXPECT_EQ(write("2F", "3010:1", "02"), "06090031");
    EXPECT_EQ(write("2F", "3010:1", "01"), "");
    EXPECT_EQ(read("6030:1"), "1E 00");
    EXPECT_EQ(read("3011"), "1E 00 00 00");
}

TEST_F(NodeQuirk, AFixedMapping)
{
    add(quirky({.hasFixedMapping = true}));
    write("23", "1800:1", "85 01 00 80");
    EXPECT_EQ(write("2F", "1A00", "00"), "06010002");
}

TEST_F(NodeQuirk, RestoringAtOnceAndOnlyUntilPowerIsOff)
{
    add(quirky({.restore = NodeQuirks::Restore::atOnce}));
    write("23", "6003", "10 00 00 00");
    write("23", "1010:1", saveOctets);
    EXPECT_EQ(write("23", "1011:1", loadOctets), "");
    EXPECT_EQ(read("6004"), "88 13 00 00");
    EXPECT_EQ(node().eepromWrites(), 1U);
    powerCycle();
    EXPECT_EQ(read("6004"), "10 00 00 00");
}

TEST_F(NodeQuirk, RestoringTheNumberAndTheRateAsWell)
{
    CanopenEncoderPlan plan = quirky({.restoresSettings = true});
    plan.rate = 250'000;
    add(plan);
    EXPECT_EQ(write("23", "1011:1", loadOctets), "");
    EXPECT_EQ(read("6004"), "88 13 00 00") << "until it is reset";
    Frames frames = send("000#81 05");
    std::ranges::copy(pass(5s), std::back_inserter(frames));
    EXPECT_EQ(std::ranges::count(frames, "701#00"), 1);
    powerCycle();
    EXPECT_EQ(node().rate(), 125'000);
}

TEST_F(NodeQuirk, ARangeThatIsTheHighestPosition)
{
    add(quirky({.rangeIsHighest = true}));
    EXPECT_EQ(read("6002"), "FF FF FF 01");
    EXPECT_EQ(write("23", "6002", "00 00 00 02"), "06090031");
    EXPECT_EQ(write("23", "6002", "63 00 00 00"), ""); // 0 to 99
    EXPECT_EQ(write("2B", "6000", "04 00"), "");
    node().shaft().turnTo(199);
    EXPECT_EQ(number("6004"), 99);
}

TEST_F(NodeQuirk, WritingOnlyInPreOperational)
{
    add(quirky({.writesOnlyPreOperational = true}));
    send("000#01 05");
    EXPECT_EQ(write("2B", "1017", "64 00"), "08000022");
    send("000#80 05");
    EXPECT_EQ(write("2B", "1017", "64 00"), "");
}

TEST_F(NodeQuirk, APresetThatIsStoredByItself)
{
    add(quirky({.keepsPreset = true}));
    write("23", "6003", "10 00 00 00");
    write("23", "6003", "11 00 00 00");
    EXPECT_EQ(node().eepromWrites(), 2U);
    powerCycle();
    EXPECT_EQ(read("6004"), "11 00 00 00");
}

TEST_F(NodeQuirk, TheNumberInAnObject)
{
    add(quirky({.hasNodeObject = true}));
    EXPECT_EQ(read("2000"), "05");
    EXPECT_EQ(write("2F", "2000", "80"), "06090031");
    EXPECT_EQ(write("2F", "2000", "09"), "");
    EXPECT_EQ(write("23", "1010:1", saveOctets), "");
    powerCycle();
    EXPECT_EQ(ask("609#40 00 20 00 00 00 00 00"), "589#4F 00 20 00 09 00 00 00");
    EXPECT_EQ(ask("609#40 00 18 01 00 00 00 00"), "589#43 00 18 01 89 01 00 00");
}

TEST_F(NodeQuirk, SwitchesDecideAboutTheNumber)
{
    add(quirky({.hasNodeObject = true, .hasSwitches = true}));
    EXPECT_EQ(write("2F", "2000", "09"), "08000021");
}

TEST_F(NodeQuirk, IdentifiersThatStayThoseOfTheOldNumber)
{
    add(quirky({.keepsIdentifiers = true, .hasNodeObject = true}));
    write("2F", "2000", "09");
    write("23", "1010:1", saveOctets);
    powerCycle();
    EXPECT_EQ(ask("609#40 00 18 01 00 00 00 00"), "589#43 00 18 01 85 01 00 00");
}

} // namespace
} // namespace codewheel::canopen
