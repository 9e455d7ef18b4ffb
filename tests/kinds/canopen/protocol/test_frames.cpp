// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/emcy.h"
#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/protocol/lss.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/protocol/sdo_frames.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>
#include <vector>

namespace codewheel::canopen {
namespace {

TEST(Frames, Nmt)
{
    const std::pair<NmtRequest, const char *> rows[] = {
        {{NmtCommand::start, 5}, "000#0105"},
        {{NmtCommand::stop, 5}, "000#0205"},
        {{NmtCommand::preOperational, 0}, "000#8000"},
        {{NmtCommand::resetNode, 127}, "000#817F"},
        {{NmtCommand::resetCommunication, 5}, "000#8205"},
    };
    for (const auto &[request, text] : rows)
        EXPECT_EQ(textOf(request.frame()), text);
}

TEST(Frames, Sync)
{
    EXPECT_EQ(textOf(syncFrame()), "080#");
    EXPECT_EQ(textOf(syncFrame(7)), "080#07");
    EXPECT_EQ(textOf(syncFrame({}, 0x0A0)), "0A0#");
}

TEST(Frames, Sdo)
{
    const std::pair<SdoOctets, const char *> rows[] = {
        {sdoRead({0x6004, 0}), "605#4004600000000000"},
        {sdoWrite({0x6003, 0}, ByteList{0, 0, 0, 0}), "605#2303600000000000"},
        {sdoWrite({0x1010, 1}, ByteList{0x73, 0x61, 0x76, 0x65}), "605#2310100173617665"},
        {sdoWrite({0x6000, 0}, ByteList{1, 2, 3}), "605#2700600001020300"},
        {sdoWrite({0x6000, 0}, ByteList{4, 0}), "605#2B00600004000000"},
        {sdoWrite({0x2000, 0}, ByteList{5}), "605#2F00200005000000"},
        {sdoWriteBegins({0x2010, 2}, 300), "605#211020022C010000"},
        {sdoNextSegment(false), "605#6000000000000000"},
        {sdoNextSegment(true), "605#7000000000000000"},
        {sdoSegment(ByteList{1, 2, 3, 4, 5, 6, 7}, false, false), "605#0001020304050607"},
        {sdoSegment(ByteList{8}, true, true), "605#1D08000000000000"},
        {sdoSegment({}, false, true), "605#0F00000000000000"},
        {sdoAbort({0x1008, 0}, abortTimeOut), "605#8008100000000405"},
    };
    for (const auto &[octets, text] : rows)
        EXPECT_EQ(textOf(frameOf(0x605, octets)), text);
}

TEST(Frames, Lss)
{
    const std::pair<LssFrame, const char *> rows[] = {
        {{.command = LssCommand::switchAll, .number = 1}, "7E5#0401000000000000"},
        {{.command = LssCommand::configureNode, .number = 5}, "7E5#1105000000000000"},
        {{.command = LssCommand::fastScan, .number = 0x12345678, .bit = 31, .word = 2, .nextWord = 3},
         "7E5#51785634121F0203"},
    };
    for (const auto &[lss, text] : rows) {
        EXPECT_EQ(textOf(lss.request()), text);
        EXPECT_EQ(LssFrame::read(lss.request().data())->nextWord, lss.nextWord);
    }
}

TEST(Frames, EmcyHasWhatTheMakerSays)
{
    const auto emcy = Emcy::read(frameFrom("085# 10 42 09 01 02 03 04 05").data());
    ASSERT_TRUE(emcy);
    EXPECT_EQ(emcy->code, 0x4210);
    EXPECT_EQ(emcy->errorRegister, 0x09);
    EXPECT_EQ(emcy->ofMaker, (std::array<std::uint8_t, 5>{1, 2, 3, 4, 5}));
    EXPECT_FALSE(emcy->isGone());
}

} // namespace
} // namespace codewheel::canopen
