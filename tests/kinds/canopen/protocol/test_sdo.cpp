// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo.h"
#include "kinds/canopen/protocol/sdo_abort.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

using Bytes = std::array<std::uint8_t, 8>;
using Kind = SdoFrame::Kind;

constexpr SdoObject position{0x6004, 0};

TEST(SdoFrame, AValueHasTheSizeThatItTells)
{
    const std::pair<std::uint8_t, std::size_t> sizes[] = {
        {0x43, 4}, {0x47, 3}, {0x4B, 2}, {0x4F, 1}, {0x42, 4}};
    for (const auto &[command, size] : sizes) {
        const auto sdo = SdoFrame::answer(Bytes{command, 0x04, 0x60, 0x00, 0x88, 0x13, 0x22, 0x33});
        ASSERT_TRUE(sdo);
        EXPECT_EQ(sdo->kind, Kind::value);
        EXPECT_EQ(sdo->object, position);
        EXPECT_EQ(sdo->data().size(), size);
        EXPECT_EQ(sdo->data().front(), 0x88);
        EXPECT_EQ(sdo->isSizeTold, command != 0x42);
    }
}

TEST(SdoFrame, WritesOfAllSizes)
{
    const std::pair<std::uint8_t, std::size_t> sizes[] = {
        {0x23, 4}, {0x27, 3}, {0x2B, 2}, {0x2F, 1}, {0x22, 4}};
    for (const auto &[command, size] : sizes) {
        const auto sdo = SdoFrame::request(Bytes{command, 0x03, 0x60, 0x00});
        ASSERT_TRUE(sdo);
        EXPECT_EQ(sdo->kind, Kind::write);
        EXPECT_EQ(sdo->data().size(), size);
    }
}

TEST(SdoFrame, WhatFollowsInSegmentsHasItsWholeSizeIfItIsTold)
{
    const auto told = SdoFrame::answer(Bytes{0x41, 0x08, 0x10, 0x00, 0x08});
    EXPECT_EQ(told->kind, Kind::valueBegins);
    EXPECT_EQ(told->wholeSize, 8);
    const auto untold = SdoFrame::request(Bytes{0x20, 0x08, 0x10, 0x00, 0x08});
    EXPECT_EQ(untold->kind, Kind::writeBegins);
    EXPECT_FALSE(untold->wholeSize);
}

TEST(SdoFrame, Segments)
{
    const auto first = SdoFrame::answer(Bytes{0x00, 'T', 'W', 'K', '-', 'T', 'R', 'N'});
    EXPECT_EQ(first->kind, Kind::segment);
    EXPECT_EQ(first->data().size(), 7);
    EXPECT_FALSE(first->toggle);
    EXPECT_FALSE(first->isLast);
    const auto last = SdoFrame::answer(Bytes{0x1D, '4'});
    EXPECT_EQ(last->data().size(), 1);
    EXPECT_EQ(last->data().front(), '4');
    EXPECT_TRUE(last->toggle);
    EXPECT_TRUE(last->isLast);
    EXPECT_EQ(SdoFrame::request(Bytes{0x70})->kind, Kind::readSegment);
    EXPECT_TRUE(SdoFrame::request(Bytes{0x70})->toggle);
    EXPECT_EQ(SdoFrame::answer(Bytes{0x30})->kind, Kind::segmentWritten);
    EXPECT_EQ(SdoFrame::request(Bytes{0x0F})->data().size(), 0);
}

TEST(SdoFrame, OnlyEightBytesAreOne)
{
    const std::array<std::uint8_t, 7> short7{0x40, 0x04, 0x60};
    EXPECT_FALSE(SdoFrame::request(short7));
    EXPECT_FALSE(SdoFrame::answer(Octets()));
}

TEST(SdoAbort, EveryCodeOfThePageIsASentence)
{
    for (const std::uint32_t code :
         {0x05030000U, 0x05040000U, 0x05040001U, 0x05040005U, 0x06010000U, 0x06010001U, 0x06010002U,
          0x06020000U, 0x06040041U, 0x06040042U, 0x06040043U, 0x06040047U, 0x06060000U, 0x06070010U,
          0x06070012U, 0x06070013U, 0x06090011U, 0x06090030U, 0x06090031U, 0x06090032U, 0x06090036U,
          0x060A0023U, 0x08000000U, 0x08000020U, 0x08000021U, 0x08000022U, 0x08000023U, 0x08000024U})
        EXPECT_TRUE(sdoAbortText(code).endsWith(u'.')) << std::hex << code;
    EXPECT_TRUE(sdoAbortText(0x12345678).isEmpty());
}

} // namespace
} // namespace codewheel::canopen
