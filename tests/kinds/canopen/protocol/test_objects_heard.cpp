// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/objects_heard.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::ByteList;
using canopen::HeardObject;
using canopen::SdoObject;

class ObjectsHeard : public testing::Test
{
protected:
    // What the last of these frames tells.
    std::vector<HeardObject> hear(std::initializer_list<const char *> frames, bool isSent = false)
    {
        std::vector<HeardObject> told;
        for (const char *frame : frames)
            told = objects.take(canopen::frameFrom(frame), isSent, now += 1ms);
        return told;
    }

    canopen::ObjectsHeard objects;
    Instant now{};
};

TEST_F(ObjectsHeard, AnAnswerToAnotherMasterTellsWhatTheNodeHas)
{
    const auto told = hear({"605#40016000..", "585#4301600000200000"});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].node, 5);
    EXPECT_EQ(told[0].object, (SdoObject{0x6001, 0}));
    EXPECT_EQ(told[0].value, (ByteList{0, 0x20, 0, 0}));
    EXPECT_FALSE(told[0].isOurs);
    EXPECT_EQ(told[0].at, 2ms);
}

TEST_F(ObjectsHeard, WhatWeAskedForIsOurs)
{
    hear({"605#40016000.."}, true);
    const auto told = hear({"585#4301600000200000"});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_TRUE(told[0].isOurs);
}

TEST_F(ObjectsHeard, AWriteCountsOnceItIsAcknowledged)
{
    EXPECT_TRUE(hear({"605#2301600000100000"}).empty());
    const auto told = hear({"585#60016000.."});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].value, (ByteList{0, 0x10, 0, 0}));
    EXPECT_TRUE(hear({"605#2301600000100000", "585#8001600030000906"}).empty()) << "refused";
    EXPECT_TRUE(hear({"605#2310100173617665", "585#60101001.."}).empty()) << "a command";
}

TEST_F(ObjectsHeard, ARefusedReadHasNoValue)
{
    const auto told = hear({"605#40056501..", "585#8005650100000206"});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_TRUE(told[0].value.empty());
}

TEST_F(ObjectsHeard, APdoCountsOnlyByTheMappingThatWasHeard)
{
    objects.setNodeOfPdos(5);
    EXPECT_TRUE(hear({"185#34120000"}).empty());
    hear({"605#40001801..", "585#4300180185010000", "605#40001A00..", "585#4F001A0002000000",
          "605#40001A01..", "585#43001A0120000460", "605#40001A02..", "585#43001A0210000365"});
    const auto told = hear({"185#341200000100"});
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0].object, (SdoObject{0x6004, 0}));
    EXPECT_EQ(told[0].value, (ByteList{0x34, 0x12, 0, 0}));
    EXPECT_EQ(told[1].object, (SdoObject{0x6503, 0}));
    EXPECT_EQ(told[1].value, (ByteList{1, 0}));
    objects.setNodeOfPdos(6);
    EXPECT_TRUE(hear({"185#341200000100"}).empty()) << "it is that of another node";
    objects.setNodeOfPdos(5);
    EXPECT_TRUE(hear({"705#00", "185#341200000100"}).empty()) << "it has started anew";
}

} // namespace
} // namespace codewheel
