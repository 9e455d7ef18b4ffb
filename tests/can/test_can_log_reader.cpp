// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/can/read_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(CanLogReader, HoweverTheFileComesInPiecesItIsTheSame)
{
    const std::string text = "\xEF\xBB\xBF(1544106679.432583) can0 185#88130000\r\n\r\nwrong\n"
                             "(1544106679.500000) can0 705#R\n(1544106679.600000) can0 080#";
    for (std::size_t atOnce = 1; atOnce <= text.size(); ++atOnce) {
        const ReadLog log = readLog(text, {}, atOnce);
        EXPECT_THAT(log.written(), ElementsAre("185#88130000", "705#R", "080#")) << atOnce;
        EXPECT_THAT(log.faults, ElementsAre(Pair(3, CanLogFault::notOfALog))) << atOnce;
    }
}

TEST(CanLogReader, ALineThatIsCutOffWhereTheReadingIsBrokenOffIsLeftOut)
{
    for (const char *cut : {"(1544106679.5) can0 185#88", "(1544106679.5) ca"}) {
        std::size_t frames = 0;
        std::size_t faults = 0;
        CanLogReader reader([&](const CanFrame &) { ++frames; },
                            [&](std::int64_t, CanLogFault) { ++faults; });
        reader.read("(1544106679.4) can0 080#\n" + std::string(cut));
        reader.breakOff();
        EXPECT_EQ(frames, 1) << cut;
        EXPECT_EQ(faults, 0) << cut;
    }
}

TEST(CanLogReader, LinesWithoutATimeDoNotWaitForOne)
{
    std::size_t frames = 0;
    CanLogReader reader([&](const CanFrame &) { ++frames; }, [](std::int64_t, CanLogFault) {});
    reader.read("(1.0) can0 185#00\n");
    for (int i = 0; i < 20'000; ++i)
        reader.read("can0 185#00\n");
    EXPECT_EQ(frames, 20'001);
}

TEST(CanLogReader, WhatWaitedIsPassedOnWhereTheReadingIsBrokenOff)
{
    std::size_t frames = 0;
    CanLogReader reader([&](const CanFrame &) { ++frames; }, [](std::int64_t, CanLogFault) {});
    reader.read("(0.5) can0 080#\n");
    EXPECT_EQ(frames, 0);
    reader.breakOff();
    EXPECT_EQ(frames, 1);
}

TEST(CanLogReader, EachFrameHasItsInterface)
{
    const ReadLog log = readLog("(1544106679.4) can1 080#\n  vcan0  080   [0]\n0.5 1 80 Rx d 0\n"
                                "0.5 12 80 Rx d 0\n0.5 0 ErrorFrame\n");
    std::vector<std::string> interfaces;
    for (const CanFrame &frame : log.frames)
        interfaces.push_back(frame.interface);
    EXPECT_THAT(interfaces, ElementsAre("can1", "vcan0", "can0", "can11", "canX"));
}

TEST(CanLogReader, ALineWithoutAnEndIsNotKept)
{
    const std::string text = std::string(1'000'000, 'x') + "\n(1.0) can0 080#\n";
    for (const std::size_t atOnce : {std::size_t{100}, text.size()}) {
        const ReadLog log = readLog(text, {}, atOnce);
        EXPECT_THAT(log.written(), ElementsAre("080#"));
        EXPECT_THAT(log.faults, ElementsAre(Pair(1, CanLogFault::tooLong)));
    }
}

TEST(CanLogReader, NothingAndBytesThatAreNoText)
{
    EXPECT_THAT(readLog("").faults, IsEmpty());
    EXPECT_THAT(readLog("\n \n\t\n").faults, IsEmpty());
    EXPECT_THAT(readLog(std::string("\0\xFF\0(\n", 5)).faults, ElementsAre(Pair(1, CanLogFault::notOfALog)));
}

TEST(CanLogReader, SumsOfNonsenseDoNotOverflow)
{
    std::string text;
    for (int i = 0; i < 20'000; ++i)
        text += "(999999999999.9) can0 080#\n";
    EXPECT_EQ(readLog(text, CanLogTimes::differences).frames.size(), 20'000);
}

TEST(CanLogReader, EveryFaultIsASentence)
{
    for (int fault = 0; fault <= static_cast<int>(CanLogFault::otherTime); ++fault)
        EXPECT_TRUE(canLogFaultText(static_cast<CanLogFault>(fault)).endsWith(u'.'));
}

} // namespace
} // namespace codewheel
