// SPDX-License-Identifier: GPL-3.0-or-later
// Frames are literal: those of CiA 301 and 406, worked out by hand.
#include "tests/kinds/canopen/simulator/node_bench.h"

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;
using Node = NodeBench;

const CanopenEncoderPlan node5{.node = 5, .raw = 5'000};

TEST_F(Node, TellsOfBootUpAndIsPreOperational)
{
    add(node5);
    powerCycle();
    node().setOn(false);
    pass(1s);
    node().setOn(true);
    EXPECT_EQ(pass(1s), Frames{"705#00"});
    EXPECT_EQ(ask("705#R"), "705#7F");
}

TEST_F(Node, AnswersAsTheRecommendationsPrintIt)
{
    add(node5);
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), "585#43 04 60 00 88 13 00 00");
    EXPECT_EQ(ask("605#23 03 60 00 00 00 00 00"), "585#60 03 60 00 00 00 00 00");
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), "585#43 04 60 00 00 00 00 00");
    EXPECT_EQ(ask("605#40 55 55 00 00 00 00 00"), "585#80 55 55 00 00 00 02 06");
    EXPECT_EQ(ask("605#23 10 10 01 73 61 76 65"), "585#60 10 10 01 00 00 00 00");
    EXPECT_EQ(ask("606#40 04 60 00 00 00 00 00"), "");
}

TEST_F(Node, ItsPositionComesByItselfOnceItIsStarted)
{
    add(node5);
    EXPECT_EQ(pass(1s), Frames{});
    EXPECT_EQ(send("000#01 05"), Frames{"185#88 13 00 00"});
    EXPECT_EQ(pass(1s), Frames{});
    node().shaft().turnBy(1);
    EXPECT_EQ(pass(1s), Frames{"185#89 13 00 00"});
}

TEST_F(Node, IsDeliveredAsAClass2Encoder)
{
    add({.node = 5, .raw = 5'000, .identity = {0x10D, 0x1234, 0x10002, 0x56789ABC}, .operatingTime = 0x1234});
    const std::pair<const char *, const char *> rows[] = {
        {"1000", "96 01 02 00"},   {"1001", "00"},
        {"1005", "80 00 00 00"},   {"1010:1", "01 00 00 00"},
        {"1014", "85 00 00 00"},   {"1017", "00 00"},
        {"1018:1", "0D 01 00 00"}, {"1018", "04"},
        {"1018:2", "34 12 00 00"}, {"1018:3", "02 00 01 00"},
        {"1018:4", "BC 9A 78 56"}, {"1200:1", "05 06 00 00"},
        {"1200:2", "85 05 00 00"}, {"1800:1", "85 01 00 00"},
        {"1800:2", "FE"},          {"1801:1", "85 02 00 00"},
        {"1801:2", "01"},          {"1A00", "01"},
        {"1A00:1", "20 00 04 60"}, {"1A01", "02"},
        {"1A01:2", "10 01 30 60"}, {"6000", "00 00"},
        {"6001", "00 20 00 00"},   {"6002", "00 00 00 02"},
        {"6003", "00 00 00 00"},   {"6004", "88 13 00 00"},
        {"6030:1", "00 00"},       {"6200", "00 00"},
        {"6300:1", "00"},          {"6310:1", "00 00 00 00"},
        {"6337:1", "00 00"},       {"6400:1", "00"},
        {"6500", "00 00"},         {"6501", "00 20 00 00"},
        {"6502", "00 10"},         {"6503", "00 00"},
        {"6504", "01 10"},         {"6505", "00 00"},
        {"6506", "17 00"},         {"6507", "02 03 04 04"},
        {"6508", "34 12 00 00"},   {"6509", "00 00 00 00"},
        {"650A:3", "FF FF FF 01"}, {"650B", "BC 9A 78 56"},
    };
    for (const auto &[object, octets] : rows)
        EXPECT_EQ(read(object), octets) << object;
}

TEST_F(Node, OfClass1HasNoScalingNorPreset)
{
    add({.node = 5,
         .form = CanopenEncoderPlan::Form::singleTurn,
         .deviceClass = 1,
         .resolution = {.stepsPerTurn = 4096, .turns = 1},
         .raw = 1});
    for (const char *object : {"6001", "6002", "6003", "6030:1", "6300:1", "6400:1", "6509"})
        EXPECT_EQ(read(object), "06020000") << object;
    EXPECT_EQ(read("1000"), "96 01 01 00");
    EXPECT_EQ(read("6004"), "01 00 00 00");
    EXPECT_EQ(write("2B", "6000", "01 00"), "");
    EXPECT_EQ(read("6004"), "FE 0F 00 00");
    EXPECT_EQ(write("2B", "6000", "04 00"), "06090030");
}

TEST_F(Node, EachReasonToRefuseHasItsCode)
{
    add(node5);
    EXPECT_EQ(read("6004:1"), "06090011");
    EXPECT_EQ(read("1003:1"), "08000024");
    const struct
    {
        const char *command;
        const char *object;
        const char *value;
        const char *code;
    } rows[] = {
        {"23", "5555", "00 00 00 00", "06020000"},
        {"23", "6003:7", "00 00 00 00", "06090011"},
        {"23", "6004", "00 00 00 00", "06010002"},
        {"2B", "6003", "00 00", "06070010"},
        {"23", "6000", "00 00 00 00", "06070010"},
        {"23", "6001", "01 20 00 00", "06090031"},
        {"23", "6001", "00 00 00 00", "06090032"},
        {"23", "6003", "00 00 00 02", "06090031"},
        {"2B", "6000", "08 00", "06090030"},
        {"23", "1010:1", "6C 6F 61 64", "08000020"},
        {"23", "1011:1", "73 61 76 65", "08000020"},
        {"2F", "1003", "01", "06090030"},
        {"23", "1800:1", "86 01 00 00", "06090030"},
        {"2F", "1800:2", "F1", "06090030"},
        {"2F", "1A00", "00", "06010000"},
        {"23", "6402:1", "FF FF FF FF", "06090036"},
        {"C2", "6003", "00 00 00 00", "05040001"},
    };
    for (const auto &row : rows)
        EXPECT_EQ(write(row.command, row.object, row.value), row.code) << row.object << ' ' << row.value;
    EXPECT_EQ(read("6004"), "88 13 00 00"); // the refused ones changed nothing
    EXPECT_EQ(read("6001"), "00 20 00 00");
    EXPECT_EQ(node().eepromWrites(), 0U);
    EXPECT_EQ(write("22", "6000", "05 00 FF FF"), ""); // its size is not told
}

TEST_F(Node, AWrongSegmentEndsATransfer)
{
    add(node5);
    EXPECT_EQ(ask("605#60 00 00 00 00 00 00 00"), "585#80 00 00 00 01 00 04 05");
    ask("605#40 08 10 00 00 00 00 00");
    EXPECT_EQ(ask("605#70 00 00 00 00 00 00 00"), "585#80 08 10 00 00 00 03 05");
    EXPECT_EQ(ask("605#60 00 00 00 00 00 00 00"), "585#80 00 00 00 01 00 04 05");
}

TEST_F(Node, TextsAreReadInSegments)
{
    add({.node = 5, .name = "CRF58-C2"});
    EXPECT_EQ(ask("605#40 08 10 00 00 00 00 00"), "585#41 08 10 00 08 00 00 00");
    EXPECT_EQ(ask("605#60 00 00 00 00 00 00 00"), "585#00 43 52 46 35 38 2D 43");
    EXPECT_EQ(ask("605#70 00 00 00 00 00 00 00"), "585#1D 32 00 00 00 00 00 00");
}

TEST_F(Node, TextsAreWrittenInSegments)
{
    add(node5);
    EXPECT_EQ(ask("605#21 00 5F 00 09 00 00 00"), "585#60 00 5F 00 00 00 00 00");
    EXPECT_EQ(ask("605#00 41 42 43 44 45 46 47"), "585#20 00 00 00 00 00 00 00");
    EXPECT_EQ(ask("605#1B 48 49 00 00 00 00 00"), "585#30 00 00 00 00 00 00 00");
    EXPECT_EQ(ask("605#40 00 5F 00 00 00 00 00"), "585#41 00 5F 00 09 00 00 00");
    EXPECT_EQ(ask("605#60 00 00 00 00 00 00 00"), "585#00 41 42 43 44 45 46 47");
    EXPECT_EQ(ask("605#70 00 00 00 00 00 00 00"), "585#1B 48 49 00 00 00 00 00");
}

TEST_F(Node, WhatIsWrittenInSegmentsHasTheLengthThatWasTold)
{
    add(node5);
    ask("605#21 00 5F 00 02 00 00 00");
    EXPECT_EQ(ask("605#00 41 42 43 44 45 46 47"), "585#80 00 5F 00 12 00 07 06");
    ask("605#21 00 5F 00 08 00 00 00");
    EXPECT_EQ(ask("605#01 41 42 43 44 45 46 47"), "585#80 00 5F 00 13 00 07 06");
    ask("605#21 03 60 00 04 00 00 00");
    EXPECT_EQ(ask("605#07 10 00 00 00 00 00 00"), "585#20 00 00 00 00 00 00 00");
    EXPECT_EQ(read("6004"), "10 00 00 00");
}

TEST_F(Node, ANewRequestEndsAnOpenTransfer)
{
    add(node5);
    ask("605#40 08 10 00 00 00 00 00");
    EXPECT_EQ(read("6004"), "88 13 00 00");
    EXPECT_EQ(ask("605#60 00 00 00 00 00 00 00"), "585#80 00 00 00 01 00 04 05");
    ask("605#40 08 10 00 00 00 00 00");
    EXPECT_EQ(ask("605#80 08 10 00 00 00 04 05"), ""); // nor is an abort answered
}

TEST_F(Node, HeedsItsNumberAndAllNodes)
{
    add(node5);
    send("000#01 06");
    EXPECT_EQ(node().state(), NmtState::preOperational);
    send("000#01 00");
    EXPECT_EQ(node().state(), NmtState::operational);
    send("000#02 05");
    EXPECT_EQ(ask("705#R"), "705#04");
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), ""); // stopped
    send("000#80 05");
    EXPECT_EQ(read("6004"), "88 13 00 00");
}

TEST_F(Node, AResetOfTheCommunicationLeavesTheProfile)
{
    add(node5);
    write("23", "6003", "10 00 00 00");
    write("2B", "1017", "F4 01");
    send("000#82 05");
    EXPECT_EQ(pass(60ms), Frames{"705#00"});
    EXPECT_EQ(read("1017"), "00 00");
    EXPECT_EQ(read("6004"), "10 00 00 00");
    send("000#81 05");
    EXPECT_EQ(pass(60ms), Frames{"705#00"});
    EXPECT_EQ(read("6004"), "88 13 00 00"); // the preset was not stored
}

TEST_F(Node, ItsHeartbeatTellsTheState)
{
    add(node5);
    write("2B", "1017", "64 00");
    pass(100ms - 2ms);
    EXPECT_EQ(pass(200ms), (Frames{"705#7F", "705#7F"}));
    EXPECT_EQ(ask("705#R"), ""); // nor is it guarded
    send("000#02 05");
    EXPECT_EQ(pass(100ms), Frames{"705#04"});
}

TEST_F(Node, GuardingTogglesAndItsEndIsNoticed)
{
    add(node5);
    write("2B", "100C", "64 00");
    write("2F", "100D", "03");
    send("000#01 05");
    EXPECT_EQ(ask("705#R"), "705#05");
    EXPECT_EQ(ask("705#R"), "705#85");
    EXPECT_EQ(ask("705#R"), "705#05");
    EXPECT_EQ(pass(290ms), Frames{});
    EXPECT_EQ(pass(20ms), Frames{"085#30 81 11 00 00 00 00 00"});
    EXPECT_EQ(node().state(), NmtState::preOperational);
    EXPECT_EQ(send("705#R"), (Frames{"085#00 00 00 00 00 00 00 00", "705#FF"}));
}

TEST_F(Node, AnAlarmIsAnEmcyAndIsKept)
{
    add(node5);
    node().setAlarms(1);
    EXPECT_EQ(pass(1ms), Frames{"085#00 50 21 00 00 00 00 00"});
    EXPECT_EQ(read("1001"), "21");
    EXPECT_EQ(read("6503"), "01 00");
    node().setAlarms(0x1001);
    EXPECT_EQ(pass(1ms), Frames{"085#0C FF A1 00 00 00 00 00"});
    node().setAlarms(0);
    EXPECT_EQ(pass(1ms), (Frames{"085#00 00 81 00 00 00 00 00", "085#00 00 00 00 00 00 00 00"}));
    EXPECT_EQ(read("1003"), "02");
    EXPECT_EQ(read("1003:1"), "0C FF 00 00");
    EXPECT_EQ(read("1003:2"), "00 50 00 00");
    EXPECT_EQ(write("2F", "1003", "00"), "");
    EXPECT_EQ(read("1003"), "00");
    node().setWarnings(0x10);
    EXPECT_EQ(pass(1ms), Frames{});
    EXPECT_EQ(read("6505"), "10 00");
}

} // namespace
} // namespace codewheel::canopen
