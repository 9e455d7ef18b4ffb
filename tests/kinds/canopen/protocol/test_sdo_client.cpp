// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_client.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

using OutcomeKind = SdoOutcome::Kind;

constexpr SdoObject sdoPosition{0x6004, 0};
constexpr SdoObject sdoPreset{0x6003, 0};
constexpr SdoObject sdoName{0x1008, 0};

SdoOutcome wasRead(ByteList value, bool isSizeTold = true)
{
    return {.kind = OutcomeKind::read, .value = std::move(value), .isSizeTold = isSizeTold};
}

SdoOutcome wasAborted(std::uint32_t code, bool isOwn = false)
{
    return {.kind = OutcomeKind::aborted, .abortCode = code, .isOwnAbort = isOwn};
}

ByteList bytesOf(std::string_view text)
{
    return {text.begin(), text.end()};
}

class SdoClientDialogue : public ::testing::Test
{
protected:
    SdoClient client{SdoIdentifiers::predefined(5)};
    Instant now = 1s;

    void read(const SdoObject &object) { client.begin({.node = 5, .object = object}, now); }
    void write(const SdoObject &object, ByteList value)
    {
        client.begin({.node = 5, .object = object, .value = std::move(value)}, now);
    }
    std::string sent()
    {
        const auto frame = client.next(now);
        return frame ? textOf(*frame) : std::string();
    }
    void comes(std::string_view text) { client.take(frameFrom(text), now); }
    // Frames in turn: what is sent, what comes.
    void passes(std::initializer_list<std::string_view> frames)
    {
        bool isSent = true;
        for (const std::string_view frame : frames) {
            if (isSent)
                EXPECT_EQ(sent(), textOf(frameFrom(frame)));
            else
                comes(frame);
            isSent = !isSent;
        }
    }
    std::optional<SdoOutcome> outcome() { return client.takeOutcome(); }
};

TEST_F(SdoClientDialogue, ReadsInOneFrame)
{
    const std::pair<const char *, SdoOutcome> rows[] = {
        {"585# 43 04 60 00 88 13 00 00", wasRead({0x88, 0x13, 0, 0})},
        {"585# 47 04 60 00 88 13 01 00", wasRead({0x88, 0x13, 1})},
        {"585# 4B 04 60 00 88 13 00 00", wasRead({0x88, 0x13})},
        {"585# 4F 04 60 00 88 00 00 00", wasRead({0x88})},
        {"585# 42 04 60 00 88 13 00 00", wasRead({0x88, 0x13, 0, 0}, false)},
        {"585# 80 04 60 00 00 00 02 06", wasAborted(0x06020000)},
    };
    for (const auto &[answer, expected] : rows) {
        read(sdoPosition);
        passes({"605# 40 04 60 00 00 00 00 00", answer});
        EXPECT_EQ(outcome(), expected) << answer;
        EXPECT_FALSE(client.isBusy());
        EXPECT_EQ(sent(), "");
    }
}

TEST_F(SdoClientDialogue, WritesInOneFrame)
{
    write(sdoPreset, {0, 0, 0, 0});
    passes({"605# 23 03 60 00 00 00 00 00", "585# 60 03 60 00 00 00 00 00"});
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::written});
    write({0x1010, 1}, {0x73, 0x61, 0x76, 0x65});
    passes({"605# 23 10 10 01 73 61 76 65", "585# 80 10 10 01 20 00 00 08"});
    EXPECT_EQ(outcome(), wasAborted(0x08000020));
}

TEST_F(SdoClientDialogue, ReadsEightLettersInSegments)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E",
            "605# 70 ..", "585# 1D 34 .."});
    EXPECT_EQ(outcome(), wasRead(bytesOf("TWK-TRN4")));
}

TEST_F(SdoClientDialogue, SegmentsWhoseSizeIsNotToldEndWithTheLast)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 40 08 10 00 ..", "605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E",
            "605# 70 ..", "585# 10 54 57 4B 2D 54 52 4E", "605# 60 ..", "585# 0F .."});
    EXPECT_EQ(outcome(), wasRead(bytesOf("TWK-TRNTWK-TRN")));
}

TEST_F(SdoClientDialogue, WritesInSegments)
{
    write(sdoName, bytesOf("TWK-TRN4"));
    passes({"605# 21 08 10 00 08 ..", "585# 60 08 10 00 ..", "605# 00 54 57 4B 2D 54 52 4E", "585# 20 ..",
            "605# 1D 34 ..", "585# 30 .."});
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::written});
    now += 10ms;
    write(sdoName, bytesOf("TWK-TRN"));
    passes({"605# 21 08 10 00 07 ..", "585# 60 08 10 00 ..", "605# 01 54 57 4B 2D 54 52 4E", "585# 20 .."});
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::written});
    now += 10ms;
    write(sdoName, {});
    passes({"605# 21 08 10 00 ..", "585# 60 08 10 00 ..", "605# 0F ..", "585# 20 .."});
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::written});
}

TEST_F(SdoClientDialogue, AnotherIdentifierIndexOrSubindexIsNotTheAnswer)
{
    read(sdoPosition);
    EXPECT_EQ(sent(), "605#4004600000000000");
    EXPECT_FALSE(client.take(frameFrom("586# 43 04 60 00 01 00 00 00"), now));
    EXPECT_TRUE(client.take(frameFrom("585# 43 03 60 00 02 00 00 00"), now));
    EXPECT_TRUE(client.take(frameFrom("585# 43 04 60 01 03 00 00 00"), now));
    EXPECT_TRUE(client.take(frameFrom("585# 43 04 60 00 04"), now));
    EXPECT_TRUE(client.take(frameFrom("585# 80 00 60 00 00 00 02 06"), now));
    EXPECT_FALSE(outcome());
    EXPECT_EQ(client.foreignAnswers(), 4);
    EXPECT_EQ(client.lateAnswers(), 0);
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_EQ(outcome(), wasRead({0x88, 0x13, 0, 0}));
}

TEST_F(SdoClientDialogue, IdentifiersMayBeOthers)
{
    SdoClient other(SdoIdentifiers{.request = 0x123, .answer = 0x456});
    other.begin({.node = 5, .object = sdoPosition}, now);
    EXPECT_EQ(textOf(*other.next(now)), "123#4004600000000000");
    EXPECT_TRUE(other.take(frameFrom("456# 43 04 60 00 88 13 00 00"), now));
    EXPECT_TRUE(other.takeOutcome());
}

TEST_F(SdoClientDialogue, AReadIsRepeatedTwice)
{
    read(sdoPosition);
    for (int attempt = 0; attempt < 3; ++attempt) {
        EXPECT_EQ(sent(), "605#4004600000000000");
        EXPECT_EQ(sent(), "");
        EXPECT_EQ(client.wakesAt(), now + 500ms);
        now += 500ms;
    }
    EXPECT_EQ(sent(), "");
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::noAnswer});
    EXPECT_FALSE(client.isBusy());
}

TEST_F(SdoClientDialogue, AWriteIsNeverRepeated)
{
    write(sdoPreset, {1, 0, 0, 0});
    EXPECT_EQ(sent(), "605#2303600001000000");
    now += 500ms;
    EXPECT_EQ(sent(), "");
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::noAnswer});
}

TEST_F(SdoClientDialogue, TheTimeForTheAnswerBeginsOnTheBus)
{
    read(sdoPosition);
    EXPECT_EQ(sent(), "605#4004600000000000");
    now += 400ms;
    client.fate(client.given(), CanFate::done, now);
    now += 499ms;
    EXPECT_EQ(sent(), "");
    now += 1ms;
    EXPECT_EQ(sent(), "605#4004600000000000");
}

TEST_F(SdoClientDialogue, WhatIsRefusedWasNotSent)
{
    write(sdoPreset, {1, 0, 0, 0});
    sent();
    client.fate(client.given(), CanFate::refused, now);
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::notSent});
    write(sdoName, bytesOf("TWK-TRN4"));
    passes({"605# 21 08 10 00 08 ..", "585# 60 08 10 00 ..", "605# 00 54 57 4B 2D 54 52 4E"});
    client.fate(client.given(), CanFate::refused, now);
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::noAnswer});
    EXPECT_EQ(sent(), "605#8008100000000405");
}

TEST_F(SdoClientDialogue, TheFateOfAnEarlierFrameIsNotThatOfTheNewOne)
{
    write(sdoPreset, {1, 0, 0, 0});
    sent();
    const std::uint64_t earlier = client.given();
    now += 500ms;
    sent();
    EXPECT_EQ(outcome()->kind, OutcomeKind::noAnswer);
    read(sdoPosition);
    EXPECT_EQ(sent(), "605#4004600000000000");
    client.fate(earlier, CanFate::refused, now);
    EXPECT_FALSE(outcome()) << "the new request was sent";
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_EQ(outcome(), wasRead({0x88, 0x13, 0, 0}));
}

TEST_F(SdoClientDialogue, AFrameThatLeavesTheQueueLateIsAnsweredLate)
{
    write(sdoPreset, {1, 0, 0, 0});
    sent();
    const std::uint64_t earlier = client.given();
    now += 500ms;
    sent();
    EXPECT_EQ(outcome()->kind, OutcomeKind::noAnswer);
    read(sdoPreset);
    now += 400ms;
    client.fate(earlier, CanFate::done, now);
    now += 499ms;
    EXPECT_EQ(sent(), "") << "its answer may still come";
    now += 1ms;
    EXPECT_EQ(sent(), "605#4003600000000000");
}

// Of two reads one is answered before the write, the other behind it.
TEST_F(SdoClientDialogue, WhatIsReadBackWasAskedForAfterTheWrite)
{
    read(sdoPreset);
    sent();
    now += 500ms;
    EXPECT_EQ(sent(), "605#4003600000000000");
    now += 300ms;
    comes("585# 43 03 60 00 00 00 00 00"); // of the first one
    EXPECT_TRUE(outcome());
    now += 201ms;
    write(sdoPreset, {1, 0, 0, 0});
    EXPECT_EQ(sent(), "") << "the answer to the second one may still come";
    comes("585# 43 03 60 00 00 00 00 00");
    EXPECT_EQ(sent(), "605#2303600001000000");
}

TEST_F(SdoClientDialogue, ALateAnswerBelongsToTheOldRequest)
{
    write(sdoPreset, {1, 0, 0, 0});
    sent();
    now += 500ms;
    sent();
    EXPECT_EQ(outcome()->kind, OutcomeKind::noAnswer);
    read(sdoPosition);
    EXPECT_EQ(sent(), "605#4004600000000000");
    comes("585# 60 03 60 00 ..");
    EXPECT_EQ(client.lateAnswers(), 1);
    EXPECT_FALSE(outcome());
    comes("585# 43 04 60 00 88 13 00 00");
    EXPECT_TRUE(outcome());
    EXPECT_EQ(client.foreignAnswers(), 0);
}

TEST_F(SdoClientDialogue, WhatALateAnswerWouldFitWaitsForIt)
{
    write(sdoPreset, {1, 0, 0, 0});
    sent();
    now += 500ms;
    sent();
    write(sdoPreset, {2, 0, 0, 0});
    EXPECT_EQ(sent(), "");
    EXPECT_EQ(client.wakesAt(), now + 500ms);
    now += 100ms;
    comes("585# 60 03 60 00 ..");
    EXPECT_FALSE(outcome());
    EXPECT_EQ(sent(), "605#2303600002000000");
    now += 500ms;
    sent();
    write(sdoPreset, {3, 0, 0, 0});
    now += 500ms;
    EXPECT_EQ(sent(), "605#2303600003000000");
}

TEST_F(SdoClientDialogue, AFrameFromBeforeTheRequestIsNotItsAnswer)
{
    read(sdoPosition);
    sent();
    CanFrame early = frameFrom("585# 43 04 60 00 01 00 00 00");
    early.time = now - 1us;
    client.take(early, now + 1ms);
    EXPECT_FALSE(outcome());
    EXPECT_EQ(client.lateAnswers(), 1);
    early.time = now;
    client.take(early, now + 1ms);
    EXPECT_TRUE(outcome());
}

TEST_F(SdoClientDialogue, ADoubledAnswerIsTakenOnce)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 .."});
    comes("585# 41 08 10 00 08 ..");
    passes({"605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E"});
    comes("585# 00 54 57 4B 2D 54 52 4E");
    EXPECT_EQ(sent(), "605#7000000000000000");
    comes("585# 00 54 57 4B 2D 54 52 4E");
    comes("585# 1D 34 ..");
    comes("585# 1D 34 ..");
    EXPECT_EQ(outcome(), wasRead(bytesOf("TWK-TRN4")));
    EXPECT_EQ(client.lateAnswers(), 4);
    EXPECT_EQ(client.foreignAnswers(), 0);
}

TEST_F(SdoClientDialogue, ADoubledAcknowledgementDoesNotConfirmTheNextWrite)
{
    write(sdoPreset, {1, 0, 0, 0});
    passes({"605# 23 03 60 00 01 ..", "585# 60 03 60 00 .."});
    EXPECT_TRUE(outcome());
    write(sdoPreset, {2, 0, 0, 0});
    EXPECT_EQ(sent(), "");
    comes("585# 60 03 60 00 ..");
    EXPECT_FALSE(outcome());
    EXPECT_EQ(sent(), "");
    now += 2ms;
    EXPECT_EQ(sent(), "605#2303600002000000");
}

TEST_F(SdoClientDialogue, AWrongToggleEndsIt)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 10 54 57 4B 2D 54 52 4E",
            "605# 80 08 10 00 00 00 03 05"});
    EXPECT_EQ(outcome(), wasAborted(0x05030000, true));
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E",
            "605# 70 ..", "585# 0D 34 ..", "605# 80 08 10 00 00 00 03 05"});
    EXPECT_EQ(outcome(), wasAborted(0x05030000, true));
    write(sdoName, bytesOf("TWK-TRN4"));
    passes({"605# 21 08 10 00 08 ..", "585# 60 08 10 00 ..", "605# 00 54 57 4B 2D 54 52 4E", "585# 30 ..",
            "605# 80 08 10 00 00 00 03 05"});
    EXPECT_EQ(outcome(), wasAborted(0x05030000, true));
}

TEST_F(SdoClientDialogue, ATimeOutWithinSegmentsAbortsAndReadsAnew)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 .."});
    now += 500ms;
    EXPECT_EQ(sent(), "605#8008100000000405");
    EXPECT_EQ(sent(), "");
    now += 100ms;
    comes("585# 00 58 58 58 58 58 58 58"); // the segment comes now, and is not one of the new transfer
    EXPECT_EQ(client.lateAnswers(), 1);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 .."});
    now += 500ms;
    EXPECT_EQ(sent(), "605#8008100000000405");
    now += 500ms; // nothing comes any more
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E",
            "605# 70 ..", "585# 1D 34 .."});
    EXPECT_EQ(outcome(), wasRead(bytesOf("TWK-TRN4")));
}

TEST_F(SdoClientDialogue, ATimeOutWithinSegmentsEndsAWrite)
{
    write(sdoName, bytesOf("TWK-TRN4"));
    passes({"605# 21 08 10 00 08 ..", "585# 60 08 10 00 ..", "605# 00 54 57 4B 2D 54 52 4E"});
    now += 500ms;
    EXPECT_EQ(sent(), "605#8008100000000405");
    EXPECT_EQ(outcome(), SdoOutcome{.kind = OutcomeKind::noAnswer});
    now += 500ms;
    EXPECT_EQ(sent(), "");
}

TEST_F(SdoClientDialogue, MoreOrLessThanWasToldIsNoValue)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 06 ..", "605# 60 ..", "585# 00 54 57 4B 2D 54 52 4E",
            "605# 80 08 10 00 12 00 07 06"});
    EXPECT_EQ(outcome(), wasAborted(0x06070012, true));
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 01 54 57 4B 2D 54 52 4E",
            "605# 80 08 10 00 13 00 07 06"});
    EXPECT_EQ(outcome(), wasAborted(0x06070013, true));
}

TEST_F(SdoClientDialogue, EndlessSegmentsEnd)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 FF FF FF FF", "605# 80 08 10 00 05 00 04 05"});
    EXPECT_EQ(outcome(), wasAborted(0x05040005, true));
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 40 08 10 00 .."});
    int segments = 0;
    for (; segments < 100'000 && !client.takeOutcome(); ++segments) {
        client.next(now);
        comes(segments % 2 == 0 ? "585# 0E .." : "585# 1E .."); // without any data
    }
    EXPECT_EQ(segments, SdoTransfer::mostSegments);
    EXPECT_EQ(sent(), "605#8008100005000405");
}

TEST_F(SdoClientDialogue, TheDeviceAbortsWithinSegments)
{
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 ..", "585# 80 08 10 00 00 00 04 05"});
    EXPECT_EQ(outcome(), wasAborted(0x05040000));
    EXPECT_EQ(sent(), "");
}

TEST_F(SdoClientDialogue, CancellingAbortsWhatHasBegun)
{
    read(sdoName);
    client.cancel(now);
    EXPECT_FALSE(client.isBusy());
    EXPECT_EQ(sent(), "");
    read(sdoName);
    passes({"605# 40 08 10 00 ..", "585# 41 08 10 00 08 ..", "605# 60 .."});
    client.cancel(now);
    EXPECT_TRUE(client.isBusy());
    EXPECT_EQ(sent(), "605#8008100000000405");
    EXPECT_FALSE(client.isBusy());
    EXPECT_FALSE(outcome());
    read(sdoPosition); // the segment may still come
    EXPECT_EQ(sent(), "");
    comes("585# 00 54 57 4B 2D 54 52 4E");
    EXPECT_EQ(sent(), "605#4004600000000000");
}

} // namespace
} // namespace codewheel::canopen
