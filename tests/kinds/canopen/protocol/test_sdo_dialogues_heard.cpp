// SPDX-License-Identifier: GPL-3.0-or-later
// Transfers as one sentence each, from literal frames a millisecond apart.
#include "kinds/canopen/protocol/sdo_dialogues.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

struct Heard
{
    std::vector<std::string> told;
    std::vector<std::string> leftToTheirFrames;
};

Heard heard(const std::vector<std::string> &frames)
{
    Heard heard;
    SdoDialogues dialogues;
    Instant at = 1s;
    for (const std::string &frame : frames) {
        const auto taken = dialogues.take(frameFrom(frame), at);
        for (const SdoDialogue &ended : taken.ended)
            heard.told.push_back(ended.text().toStdString());
        if (!taken.isPart)
            heard.leftToTheirFrames.push_back(frame);
        at += 1ms;
    }
    for (const SdoDialogue &ended : dialogues.overdue(at + SdoDialogues::patience))
        heard.told.push_back(ended.text().toStdString());
    return heard;
}

using Texts = std::vector<std::string>;

TEST(SdoDialoguesHeard, AReadAndAWriteAreOneSentenceEach)
{
    const Heard it = heard({"605#40 04 60 00 ..", "585#43 04 60 00 88 13 00 00", // 5000
                            "605#23 03 60 00 ..", "585#60 03 60 00 .."});
    EXPECT_EQ(it.told, (Texts{"Node 5: read 6004h:0 = 1388h = 5000 (1.0 ms)",
                              "Node 5: write 6003h:0 = 0h = 0 (1.0 ms)"}));
    EXPECT_EQ(it.leftToTheirFrames, Texts());
}

TEST(SdoDialoguesHeard, SegmentsAreOneTransfer)
{
    const Heard read = heard({"605#40 08 10 00 ..", "585#41 08 10 00 0A 00 00 00", "605#60 ..",
                              "585#00 45 6E 63 6F 64 65 72", "605#70 ..", "585#19 20 31 32 ..",
                              "605#21 08 10 00 09 00 00 00", "585#60 08 10 00 ..",
                              "605#00 01 02 03 04 05 06 07", "585#20 ..", "605#1B 08 09 ..", "585#30 .."});
    EXPECT_EQ(read.told, (Texts{"Node 5: read 1008h:0 = \"Encoder 12\" (5.0 ms)",
                                "Node 5: write 1008h:0 = 01 02 03 04 05 06 07 08 09 (5.0 ms)"}));
    EXPECT_EQ(read.leftToTheirFrames, Texts());
}

TEST(SdoDialoguesHeard, AnAbortSaysWhoseAndWhy)
{
    const Heard it = heard({"605#40 04 60 01 ..", "585#80 04 60 01 11 00 09 06", //
                            "605#40 04 60 00 ..", "605#80 04 60 00 00 00 04 05", //
                            "605#2B 03 60 00 05 00 ..", "585#80 03 60 00 78 56 34 12"});
    EXPECT_EQ(it.told,
              (Texts{"Node 5: read 6004h:1, refused, 06090011h: There is no such subindex. (1.0 ms)",
                     "Node 5: read 6004h:0, broken off by whoever asked, 05040000h: The transfer timed "
                     "out. (1.0 ms)",
                     "Node 5: write 6003h:0 = 5h = 5, refused, 12345678h (1.0 ms)"}));
}

TEST(SdoDialoguesHeard, WhatNobodyAnswersIsSaidSo)
{
    const Heard it = heard(
        {"605#40 04 60 00 ..", "605#40 04 60 00 ..", "585#43 04 60 00 88 13 00 00", "606#2F 00 65 00 01 .."});
    EXPECT_EQ(it.told,
              (Texts{"Node 5: read 6004h:0, not answered", "Node 5: read 6004h:0 = 1388h = 5000 (1.0 ms)",
                     "Node 6: write 6500h:0 = 1h = 1, not answered"}));
}

TEST(SdoDialoguesHeard, WhatIsOfNoDialogueIsLeftToItsFrame)
{
    const Texts strangers{
        "185#88 13 00 00",             // no SDO
        "585#43 04 60 00 88 13 00 00", // nobody asked
        "605#70 ..",                   // no transfer is under way
        "605#80 04 60 00 00 00 04 05", //
        "605#A0 08 10 00 7F 00 00 00", // a block transfer
        "605#40 04 60",                // no SDO has three bytes
    };
    EXPECT_EQ(heard(strangers).leftToTheirFrames, strangers);
    EXPECT_EQ(heard(strangers).told, Texts());
    // The answer to another question does not end this one; a doubled one belongs to none.
    const Heard it = heard({"605#40 04 60 00 ..", "585#43 03 60 00 01 00 00 00",
                            "585#43 04 60 00 88 13 00 00", "585#43 04 60 00 88 13 00 00"});
    EXPECT_EQ(it.told, (Texts{"Node 5: read 6004h:0 = 1388h = 5000 (2.0 ms)"}));
    EXPECT_EQ(it.leftToTheirFrames, (Texts{"585#43 03 60 00 01 00 00 00", "585#43 04 60 00 88 13 00 00"}));
}

} // namespace
} // namespace codewheel::canopen
