// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/lss_client.h"
#include "tests/kinds/canopen/protocol/frame_literal.h"

#include <gtest/gtest.h>

using namespace std::chrono_literals;

namespace codewheel::canopen {
namespace {

using LssEnd = LssOutcome::Kind;
using LssTask = LssRequest::Kind;

constexpr NodeIdentity encoderIdentity{{0x0000010D, 0x12345678, 0x00010002, 0x80000001}};

class LssDialogue : public ::testing::Test
{
protected:
    LssClient client;
    Instant now = 1s;

    std::string sent()
    {
        const auto frame = client.next(now);
        return frame ? textOf(*frame) : std::string();
    }
    void comes(std::string_view text) { client.take(frameFrom(text), now); }
    LssOutcome outcomeOf(const LssRequest &request, std::string_view out, std::string_view in)
    {
        client.begin(request, now);
        EXPECT_EQ(sent(), textOf(frameFrom(out)));
        comes(in);
        return client.takeOutcome().value_or(LssOutcome{.kind = LssEnd::notSent});
    }
    // What nobody answers, to its end.
    std::optional<LssOutcome> untilSilent()
    {
        now = client.wakesAt().value();
        EXPECT_EQ(sent(), "");
        return client.takeOutcome();
    }
};

TEST_F(LssDialogue, TheOnlyDeviceGetsANumber)
{
    client.begin({.kind = LssTask::configureAll}, now);
    EXPECT_EQ(sent(), "7E5#0401000000000000");
    EXPECT_EQ(untilSilent(), LssOutcome{.kind = LssEnd::done});
    EXPECT_EQ(outcomeOf({.kind = LssTask::setNode, .number = 5}, "7E5# 11 05 ..", "7E4# 11 00 ..").kind,
              LssEnd::done);
    EXPECT_EQ(outcomeOf({.kind = LssTask::store}, "7E5# 17 ..", "7E4# 17 00 ..").kind, LssEnd::done);
    client.begin({.kind = LssTask::operateAll}, now);
    EXPECT_EQ(sent(), "7E5#0400000000000000");
    client.fate(client.given(), CanFate::done, now);
    EXPECT_EQ(untilSilent(), LssOutcome{.kind = LssEnd::done});
    EXPECT_FALSE(client.isBusy());
}

TEST_F(LssDialogue, RefusalsHaveTheirCode)
{
    const std::tuple<LssRequest, const char *, const char *, int, int> rows[] = {
        {{.kind = LssTask::setNode, .number = 200}, "7E5# 11 C8 ..", "7E4# 11 01 ..", 1, 0},
        {{.kind = LssTask::setRate, .number = 5}, "7E5# 13 00 05 ..", "7E4# 13 01 ..", 1, 0},
        {{.kind = LssTask::store}, "7E5# 17 ..", "7E4# 17 02 ..", 2, 0},
        {{.kind = LssTask::store}, "7E5# 17 ..", "7E4# 17 FF 07 ..", 255, 7},
    };
    for (const auto &[request, out, in, code, ofMaker] : rows) {
        const LssOutcome outcome = outcomeOf(request, out, in);
        EXPECT_EQ(outcome.kind, LssEnd::refused) << out;
        EXPECT_EQ(outcome.code, code);
        EXPECT_EQ(outcome.codeOfMaker, ofMaker);
    }
}

TEST_F(LssDialogue, Rates)
{
    EXPECT_EQ(outcomeOf({.kind = LssTask::setRate, .number = 4}, "7E5# 13 00 04 ..", "7E4# 13 00 ..").kind,
              LssEnd::done);
    client.begin({.kind = LssTask::activate, .number = 1000}, now);
    EXPECT_EQ(sent(), "7E5#15E8030000000000");
    EXPECT_EQ(untilSilent(), LssOutcome{.kind = LssEnd::done});
}

TEST_F(LssDialogue, TheNumberIsInquired)
{
    EXPECT_EQ(outcomeOf({.kind = LssTask::inquireNode}, "7E5# 5E ..", "7E4# 5E 05 ..").node, 5);
    const LssOutcome none = outcomeOf({.kind = LssTask::inquireNode}, "7E5# 5E ..", "7E4# 5E FF ..");
    EXPECT_EQ(none.kind, LssEnd::done);
    EXPECT_FALSE(none.node);
}

TEST_F(LssDialogue, TheIdentityIsInquired)
{
    client.begin({.kind = LssTask::inquireIdentity}, now);
    const std::pair<const char *, const char *> rows[] = {
        {"7E5#5A00000000000000", "7E4# 5A 0D 01 00 00 .."},
        {"7E5#5B00000000000000", "7E4# 5B 78 56 34 12 .."},
        {"7E5#5C00000000000000", "7E4# 5C 02 00 01 00 .."},
        {"7E5#5D00000000000000", "7E4# 5D 01 00 00 80 .."},
    };
    for (const auto &[out, in] : rows) {
        EXPECT_EQ(sent(), out);
        comes("7E4# 5E 01 .."); // of another question
        comes(in);
    }
    EXPECT_EQ(client.takeOutcome(),
              (LssOutcome{.kind = LssEnd::done, .identity = encoderIdentity, .extraAnswers = 4}));
}

TEST_F(LssDialogue, OneIsSelectedByItsIdentity)
{
    client.begin({.kind = LssTask::select, .identity = encoderIdentity}, now);
    EXPECT_EQ(sent(), "7E5#400D010000000000");
    EXPECT_EQ(sent(), "7E5#4178563412000000");
    client.fate(client.given(), CanFate::done, now);
    EXPECT_EQ(sent(), "7E5#4202000100000000");
    EXPECT_EQ(sent(), "7E5#4301000080000000");
    EXPECT_EQ(sent(), "");
    comes("7E4# 44 ..");
    EXPECT_EQ(client.takeOutcome()->kind, LssEnd::done);
}

TEST_F(LssDialogue, NoAnswer)
{
    client.begin({.kind = LssTask::setNode, .number = 5}, now);
    sent();
    EXPECT_EQ(client.wakesAt(), now + 500ms);
    EXPECT_EQ(untilSilent()->kind, LssEnd::noAnswer);
    client.begin({.kind = LssTask::store}, now);
    sent();
    EXPECT_EQ(client.wakesAt(), now + 5s);
    client.fate(client.given(), CanFate::refused, now);
    EXPECT_EQ(client.takeOutcome()->kind, LssEnd::notSent);
}

TEST_F(LssDialogue, TheFateOfAnEarlierRequestIsNotThatOfTheNewOne)
{
    client.begin({.kind = LssTask::setNode, .number = 5}, now);
    sent();
    const std::uint64_t earlier = client.given();
    EXPECT_EQ(untilSilent()->kind, LssEnd::noAnswer);
    client.begin({.kind = LssTask::store}, now);
    sent();
    client.fate(earlier, CanFate::refused, now);
    EXPECT_TRUE(client.isBusy());
}

TEST_F(LssDialogue, ASecondAnswerIsCounted)
{
    EXPECT_EQ(outcomeOf({.kind = LssTask::setNode, .number = 5}, "7E5# 11 05 ..", "7E4# 11 00 ..").kind,
              LssEnd::done);
    comes("7E4# 11 00 ..");
    client.begin({.kind = LssTask::operateAll}, now);
    sent();
    EXPECT_EQ(untilSilent()->extraAnswers, 1);
    EXPECT_EQ(outcomeOf({.kind = LssTask::store}, "7E5# 17 ..", "7E4# 17 00 ..").extraAnswers, 0);
    EXPECT_FALSE(client.take(frameFrom("7E5# 11 00 .."), now));
}

// A device without a number (CiA 305, fast scan), as the page tells it.
struct ScannedDevice
{
    NodeIdentity identity;
    std::size_t word = 0;
    bool isSelected = false;

    bool answers(const CanFrame &frame)
    {
        const auto &in = frame.bytes;
        std::uint32_t id = 0;
        for (std::size_t at = 4; at >= 1; --at)
            id = id << 8 | in[at];
        if (in[0] != 0x51 || isSelected)
            return false;
        if (in[5] == 0x80) {
            word = 0;
            return true;
        }
        if (in[6] != word || (id ^ identity.words[word]) >> in[5] != 0)
            return false;
        if (in[5] == 0 && in[7] != word) {
            isSelected = in[7] < in[6];
            word = in[7];
        }
        return true;
    }
};

TEST_F(LssDialogue, AFastScanFindsTheIdentity)
{
    for (const Instant answerTime : {50ms, 200ms}) {
        client = LssClient({.fastScan = answerTime});
        ScannedDevice device{encoderIdentity};
        client.begin({.kind = LssTask::fastScan}, now);
        const Instant begun = now;
        int frames = 0;
        while (client.isBusy() && frames < 1'000) {
            if (const auto frame = client.next(now)) {
                EXPECT_EQ(client.step(), frames);
                ++frames;
                if (device.answers(*frame))
                    comes("7E4# 4F ..");
            } else if (client.isBusy()) {
                now = client.wakesAt().value();
            }
        }
        EXPECT_EQ(client.takeOutcome(), (LssOutcome{.kind = LssEnd::done, .identity = encoderIdentity}));
        EXPECT_TRUE(device.isSelected);
        EXPECT_EQ(frames, 133);
        EXPECT_EQ(now - begun, answerTime * 21); // the bits that are 1
    }
}

TEST_F(LssDialogue, TheFramesOfAFastScan)
{
    client = LssClient({.fastScan = 1ms}); // 50 ms at least
    client.begin({.kind = LssTask::fastScan}, now);
    EXPECT_EQ(sent(), "7E5#5100000000800000");
    comes("7E4# 4F ..");
    EXPECT_EQ(sent(), "7E5#51000000001F0000");
    now += 49ms;
    EXPECT_EQ(sent(), "");
    now += 1ms;
    EXPECT_EQ(sent(), "7E5#51000000801E0000");
    for (int bit = 29; bit >= 0; --bit) {
        comes("7E4# 4F ..");
        EXPECT_NE(sent(), "");
    }
    comes("7E4# 4F ..");
    EXPECT_EQ(sent(), "7E5#5100000080000001"); // all of the vendor
    comes("7E4# 4F ..");
    EXPECT_EQ(sent(), "7E5#51000000001F0101");
}

TEST_F(LssDialogue, AFastScanWithNobodyThereOrAnUnconfirmedWordIsNoAnswer)
{
    client.begin({.kind = LssTask::fastScan}, now);
    EXPECT_EQ(sent(), "7E5#5100000000800000");
    EXPECT_EQ(untilSilent()->kind, LssEnd::noAnswer);
    client.begin({.kind = LssTask::fastScan}, now);
    sent();
    comes("7E4# 4F ..");
    int frames = 1;
    for (; client.isBusy() && frames < 1'000; now = client.wakesAt().value_or(now))
        frames += sent().empty() ? 0 : 1;
    EXPECT_EQ(frames, 35) << "it is asked once more who is there";
    EXPECT_EQ(client.takeOutcome(), (LssOutcome{.kind = LssEnd::noAnswer, .isIncomplete = true}));
}

// The silence of one that is late means 1, where it has 0.
TEST_F(LssDialogue, AFastScanThatLostAnAnswerIsDoneOnceMoreAndMoreSlowly)
{
    ScannedDevice device{encoderIdentity};
    client.begin({.kind = LssTask::fastScan}, now);
    int frames = 0;
    int answers = 0;
    while (client.isBusy() && frames < 1'000) {
        if (const auto frame = client.next(now)) {
            ++frames;
            if (device.answers(*frame) && ++answers != 20)
                comes("7E4# 4F ..");
        } else if (client.isBusy()) {
            now = client.wakesAt().value();
        }
    }
    EXPECT_EQ(client.takeOutcome(), (LssOutcome{.kind = LssEnd::done, .identity = encoderIdentity}));
    EXPECT_TRUE(device.isSelected);
    EXPECT_EQ(frames, 34 + 133);
}

} // namespace
} // namespace codewheel::canopen
