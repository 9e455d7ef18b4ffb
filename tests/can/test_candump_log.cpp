// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as candump of can-utils writes them: candump -L, and its screen with -t, -x, -a and -e.
#include "tests/can/read_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

struct CandumpLine
{
    const char *text;
    const char *written;
};

const CandumpLine goodCandumpLines[] = {
    {"(1544106679.432583) can0 185#88130000", "185#88130000"},
    {"(1544106679.432583) can0 185#88130000 R", "185#88130000"},
    {"(1544106679.432583) can0 185#88130000 T", "185#88130000"},
    {"(1544106679.432583)  vcan0  185#88.13.00.00", "185#88130000"},
    {"(0000000000.000000) can0 000#0105", "000#0105"},
    {"(1544106679.432583) can0 080#", "080#"},
    {"(1544106679.432583) can0 705#R", "705#R"},
    {"(1544106679.432583) can0 100#R8", "100#R8"},
    {"(1544106679.432583) can0 100#R R", "100#R"},
    {"(1544106679.432583) can0 100#R8_9", "100#R8"},
    {"(1544106679.432583) can0 00000005#01", "00000005#01"},
    {"(1544106679.432583) can0 0CFFE0E0#0102030405060708", "0CFFE0E0#0102030405060708"},
    {"(1544106679.432583) can0 185#0102030405060708_F", "185#0102030405060708"},
    {"(1544106679.432583) can0 20000004#0004000000000000", "20000004#0004000000000000"},
    {"(1544106679.432583) can0 20000080#", "20000080#0000000000000000"},
    {"  can0  057   [8]  C7 35 01 02 03 04 05 06", "057#C735010203040506"},
    {"  can0  00000057   [1]  C7", "00000057#C7"},
    {"  can0  080   [0] ", "080#"},
    {"  can0  057   [2]  23 35                     '#5'", "057#2335"},
    {"  can0  RX - -  057   [2]  C7 35", "057#C735"},
    {"  can0  TX B E  057   [2]  C7 35", "057#C735"},
    {"  can0  705   [0]  remote request", "705#R"},
    {"  can0  705   [8]  remote request", "705#R8"},
    {"  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME", "20000004#0004000000000000"},
    {" (1544106679.432583)  can0  057   [2]  C7 35", "057#C735"},
    {" (000.010000)  can0  057   [2]  C7 35", "057#C735"},
    {" (2018-12-06 14:31:19.432583)  can0  057   [2]  C7 35", "057#C735"},
    {"(2018-12-06 14:31:19.432583) can0 057#C735", "057#C735"},
    {"(1544106679.432583) can0 185#8813\r", "185#8813"},
};

TEST(CandumpLog, EveryFormOfALineIsRead)
{
    for (const CandumpLine &line : goodCandumpLines) {
        const ReadLog log = readLog(std::string(line.text) + '\n');
        EXPECT_THAT(log.written(), ElementsAre(line.written)) << line.text;
        EXPECT_THAT(log.faults, IsEmpty()) << line.text;
    }
}

struct OddCandumpLine
{
    const char *text;
    CanLogFault fault;
};

const OddCandumpLine oddCandumpLines[] = {
    {"hello", CanLogFault::notOfALog},
    {"one two three four", CanLogFault::notOfALog},
    {"(1544106679.432583 can0 185#8813", CanLogFault::badTime},
    {"(yesterday) can0 185#8813", CanLogFault::badTime},
    {"(2018-13-06 14:31:19.4) can0 185#8813", CanLogFault::badTime},
    {"(2018-12-06 14:31:60.4) can0 185#8813", CanLogFault::badTime},
    {"(1.0) can0 1850#8813", CanLogFault::badIdentifier},
    {"(1.0) can0 XYZ#8813", CanLogFault::badIdentifier},
    {"(1.0) can0 800#8813", CanLogFault::badIdentifier},
    {"(1.0) can0 40000000#8813", CanLogFault::badIdentifier},
    {"(1.0) can0 185#881", CanLogFault::badData},
    {"(1.0) can0 185#88ZZ", CanLogFault::badData},
    {"(1.0) can0 185#881388138813881388", CanLogFault::wrongLength},
    {"(1.0) can0 185#RX", CanLogFault::wrongLength},
    {"(1.0) can0 20000004#R8", CanLogFault::badData},
    {"(1.0) can0 185#8813 R T", CanLogFault::notOfALog},
    {"(1.0) can0 185#8813 8813", CanLogFault::notOfALog},
    {"(1.0) can0 185", CanLogFault::notOfALog},
    {"  can0  057   [3]  C7 35", CanLogFault::wrongLength},
    {"  can0  057   [1]  C7 35", CanLogFault::wrongLength},
    {"  can0  057   [9]  C7 35", CanLogFault::wrongLength},
    {"  can0  057   [2]  C7 11000111", CanLogFault::badData},
    {"  can0  57   [1]  C7", CanLogFault::badIdentifier},
    {"(1.0) can0 185##0112233", CanLogFault::canFd},
    {"  can0  185  [08]  00 11 22 33 44 55 66 77", CanLogFault::canFd},
    {"  can0  185  [12]  00 11 22 33 44 55 66 77 88 99 AA BB", CanLogFault::canFd},
    {"(1.0) can0 00123#81:00:12345678#11223344", CanLogFault::canXl},
};

TEST(CandumpLog, WhatIsNotReadHasItsNumberAndItsReasonAndTheRestIsRead)
{
    for (const OddCandumpLine &line : oddCandumpLines) {
        const ReadLog log = readLog("(1.0) can0 000#0105\n" + std::string(line.text) + "\n(1.1) can0 080#\n");
        EXPECT_THAT(log.written(), ElementsAre("000#0105", "080#")) << line.text;
        EXPECT_THAT(log.faults, ElementsAre(Pair(2, line.fault))) << line.text;
    }
}

TEST(CandumpLog, CanFdIsCounted)
{
    const ReadLog log = readLog("(1.0) can0 185##0112233\n(1.1) can0 185##1\n(1.2) can0 185#00\n");
    EXPECT_EQ(log.canFdFrames, 2);
    EXPECT_EQ(log.frames.size(), 1);
}

TEST(CandumpLog, WhatTheScreenTellsBelowAnErrorFrameIsNoLineOfItsOwn)
{
    const ReadLog log = readLog("  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME\n"
                                "\tcontroller-problem{rx-error-warning}\n"
                                "  can0  705   [1]  05\n");
    EXPECT_THAT(log.written(), ElementsAre("20000004#0004000000000000", "705#05"));
    EXPECT_THAT(log.faults, IsEmpty());
}

} // namespace
} // namespace codewheel
