// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as CANalyzer and CANoe of Vector, log2asc of can-utils and BUSMASTER write them.
#include "tests/can/read_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

struct AscLine
{
    const char *text;
    const char *written;
};

const AscLine goodAscLines[] = {
    {"0.020000 1 185x Rx d 2 88 13", "00000185#8813"},
    {"   0.020000 1  185             Rx   d 2 88 13", "185#8813"},
    {"   0.015991 2  1C4D8D80x       Tx   d 8 00 01 02 03 04 05 06 07  Length = 0 BitCount = 64 ID = 88x",
     "1C4D8D80#0001020304050607"},
    {"   0.020000 1  80              Rx   d 0", "080#"},
    {"   0.020000 1  300             Rx   r 8", "300#R8"},
    {"   0.020000 1  300             Rx   r", "300#R"},
    {"   0.020000 1  185             Rx   d F 00 01 02 03 04 05 06 07", "185#0001020304050607"},
    {"   2.501000 1  ErrorFrame", "20000000#0000000000000000"},
    {"   2.5010 1  ErrorFrame Flags = 0xe CodeExt = 0x20a2", "20000000#0000000000000000"},
};

TEST(AscLog, EveryFormOfAFrameIsRead)
{
    for (const AscLine &line : goodAscLines) {
        const ReadLog log = readLog("base hex  timestamps absolute\n" + std::string(line.text) + '\n');
        EXPECT_THAT(log.written(), ElementsAre(line.written)) << line.text;
        EXPECT_THAT(log.faults, IsEmpty()) << line.text;
    }
}

TEST(AscLog, AFrameIsReadWithoutAHeader)
{
    EXPECT_THAT(readLog("0.020000 1 185x Rx d 2 88 13\n").written(), ElementsAre("00000185#8813"));
}

TEST(AscLog, DecimalIdentifiersAndData)
{
    const ReadLog log = readLog("base dec  timestamps absolute\n"
                                "0.02 1 389 Rx d 2 136 19\n"
                                "0.03 1 389 Rx d 2 136 256\n");
    EXPECT_THAT(log.written(), ElementsAre("185#8813"));
    EXPECT_THAT(log.faults, ElementsAre(Pair(3, CanLogFault::badData)));
}

TEST(AscLog, HeadersTriggerBlocksCommentsAndOtherEventsAreSkipped)
{
    const ReadLog log = readLog("date Wed Jun 5 03:18:58 pm 2002\n"
                                "base hex  timestamps absolute\n"
                                "internal events logged\n"
                                "// version 7.0.0\n"
                                "Begin Triggerblock Wed Jun 5 03:18:58.123 pm 2002\n"
                                ";  time  can ident        attr dlc data\n"
                                "   0.0000 Start of measurement\n"
                                "   1.0000 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.0%\n"
                                "   1.0008 CAN 1 Status:chip status error active\n"
                                "   1.2000 1  185             TxRq d 2 88 13\n"
                                "   1.5506 2  123             Rx   d 2 88 13\n"
                                "   1.7000 log trigger event\n"
                                "End TriggerBlock\n");
    EXPECT_THAT(log.written(), ElementsAre("123#8813"));
    EXPECT_THAT(log.faults, IsEmpty());
}

struct OddAscLine
{
    const char *text;
    CanLogFault fault;
};

const OddAscLine oddAscLines[] = {
    {"nonsense", CanLogFault::notOfALog},
    {"0.02 1 185 Rx d 3 88 13", CanLogFault::wrongLength},
    {"0.02 1 185 Rx d 1 88 13", CanLogFault::wrongLength},
    {"0.02 1 185 Rx d", CanLogFault::wrongLength},
    {"0.02 1 185", CanLogFault::wrongLength},
    {"0.02 1 185 Rx d 2 88 1G", CanLogFault::badData},
    {"0.02 1 185 Rx", CanLogFault::badData},
    {"0.02 1 185 Rxx d 2 88 13", CanLogFault::badDirection},
    {"0.02 1 185 In r 2", CanLogFault::badDirection},
    {"0.02 1 185 Rx r 99", CanLogFault::wrongLength},
    {"0.02 1 EngineData Rx d 2 88 13", CanLogFault::badIdentifier},
    {"0.02 1 800 Rx d 2 88 13", CanLogFault::badIdentifier},
    {"0.02 1 20000000x Rx d 2 88 13", CanLogFault::badIdentifier},
    {"0.02 CANFD 1 Rx 185 1 0 d 16 00 00", CanLogFault::canFd},
    {"0.02 CANXL 2 Rx XLFF 984438 4656 432", CanLogFault::canXl},
};

TEST(AscLog, WhatIsNotReadHasItsNumberAndItsReasonAndTheRestIsRead)
{
    for (const OddAscLine &line : oddAscLines) {
        const ReadLog log =
            readLog("base hex  timestamps absolute\n" + std::string(line.text) + "\n0.03 1 80 Rx d 0\n");
        EXPECT_THAT(log.written(), ElementsAre("080#")) << line.text;
        EXPECT_THAT(log.faults, ElementsAre(Pair(2, line.fault))) << line.text;
    }
}

TEST(AscLog, ANumberInATextIsNoEvent)
{
    EXPECT_THAT(readLog("0.02 apples\n").faults, ElementsAre(Pair(1, CanLogFault::notOfALog)));
}

// It ends the line with the base only where it says what the times are.
TEST(AscLog, TheFirstFrameOfBusmasterMayBeBehindTheBase)
{
    EXPECT_THAT(readLog("base hex  52279.432500 1 185 Rx d 2 88 13\n52279.5 1 80 Rx d 0\n").written(),
                ElementsAre("185#8813", "080#"));
}

} // namespace
} // namespace codewheel
