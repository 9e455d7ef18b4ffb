// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of CiA 305.
#include "tests/kinds/canopen/simulator/node_bench.h"

#include <cstdio>

namespace codewheel::canopen {
namespace {

using namespace std::chrono_literals;

class NodeLss : public NodeBench
{
protected:
    bool isThere(std::uint32_t number, int bit, int word, int next)
    {
        char text[32];
        std::snprintf(text, sizeof text, "7E5#51 %02X %02X %02X %02X %02X %02X %02X", number & 0xFF,
                      number >> 8 & 0xFF, number >> 16 & 0xFF, number >> 24, bit, word, next);
        const std::string answer = ask(text);
        EXPECT_TRUE(answer.empty() || answer == "7E4#4F 00 00 00 00 00 00 00") << answer;
        return !answer.empty();
    }
    // The identity of one without a number, which is selected; empty: there is none.
    std::optional<std::array<std::uint32_t, 4>> scan()
    {
        if (!isThere(0, 0x80, 0, 0))
            return std::nullopt;
        std::array<std::uint32_t, 4> identity{};
        for (int word = 0; word < 4; ++word) {
            std::uint32_t &number = identity.at(static_cast<std::size_t>(word));
            for (int bit = 31; bit >= 0; --bit)
                if (!isThere(number, bit, word, word))
                    number |= 1U << bit;
            EXPECT_TRUE(isThere(number, 0, word, word == 3 ? 0 : word + 1));
        }
        return identity;
    }
};

TEST_F(NodeLss, TheOnlyDeviceGetsItsNumber)
{
    add({.raw = 5'000, .identity = {0x10D, 2, 3, 4}});
    EXPECT_FALSE(node().node());
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), "");
    EXPECT_EQ(ask("7E5#11 05 00 00 00 00 00 00"), ""); // not before it is told
    EXPECT_EQ(ask("7E5#04 01 00 00 00 00 00 00"), "");
    EXPECT_EQ(ask("7E5#5A 00 00 00 00 00 00 00"), "7E4#5A 0D 01 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5B 00 00 00 00 00 00 00"), "7E4#5B 02 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5C 00 00 00 00 00 00 00"), "7E4#5C 03 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5D 00 00 00 00 00 00 00"), "7E4#5D 04 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5E 00 00 00 00 00 00 00"), "7E4#5E FF 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#11 00 00 00 00 00 00 00"), "7E4#11 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#11 80 00 00 00 00 00 00"), "7E4#11 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#11 05 00 00 00 00 00 00"), "7E4#11 00 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#17 00 00 00 00 00 00 00"), "7E4#17 00 00 00 00 00 00 00");
    EXPECT_EQ(node().eepromWrites(), 1U);
    EXPECT_EQ(ask("7E5#04 00 00 00 00 00 00 00"), "");
    EXPECT_EQ(pass(60ms), Frames{"705#00"});
    EXPECT_EQ(ask("605#40 04 60 00 00 00 00 00"), "585#43 04 60 00 88 13 00 00");
    powerCycle();
    EXPECT_EQ(node().node(), 5);
}

TEST_F(NodeLss, OneWithANumberHasTheNewOneAfterAReset)
{
    add({.node = 5});
    send("7E5#04 01 00 00 00 00 00 00");
    ask("7E5#11 06 00 00 00 00 00 00");
    send("7E5#04 00 00 00 00 00 00 00");
    EXPECT_EQ(pass(1s), Frames{});
    EXPECT_EQ(node().node(), 5);
    send("000#82 05");
    EXPECT_EQ(pass(60ms), Frames{"706#00"});
    powerCycle(); // it was not stored
    EXPECT_EQ(node().node(), 5);
}

TEST_F(NodeLss, IsSelectedByItsIdentity)
{
    add({.node = 5, .identity = {0x10D, 2, 3, 4}});
    add({.node = 6, .identity = {0x10D, 2, 3, 5}});
    EXPECT_EQ(ask("7E5#40 0D 01 00 00 00 00 00"), "");
    EXPECT_EQ(ask("7E5#41 02 00 00 00 00 00 00"), "");
    EXPECT_EQ(ask("7E5#42 03 00 00 00 00 00 00"), "");
    EXPECT_EQ(ask("7E5#43 05 00 00 00 00 00 00"), "7E4#44 00 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#5E 00 00 00 00 00 00 00"), "7E4#5E 06 00 00 00 00 00 00");
}

TEST_F(NodeLss, AllMayBeSwitchedAtOnce)
{
    add({.node = 5, .identity = {0x10D, 2, 3, 4}});
    add({.node = 6, .identity = {0x10D, 2, 3, 5}});
    send("7E5#04 01 00 00 00 00 00 00");
    EXPECT_EQ(send("7E5#5E 00 00 00 00 00 00 00"),
              (Frames{"7E4#5E 05 00 00 00 00 00 00", "7E4#5E 06 00 00 00 00 00 00"}));
}

TEST_F(NodeLss, ARateIsActivatedWithSilenceAround)
{
    add({.node = 5});
    send("7E5#04 01 00 00 00 00 00 00");
    for (const char *place : {"05", "09", "0A"})
        EXPECT_EQ(ask(std::string("7E5#13 00 ") + place + " 00 00 00 00 00"), "7E4#13 01 00 00 00 00 00 00");
    EXPECT_EQ(ask("7E5#13 01 03 00 00 00 00 00"), "7E4#13 01 00 00 00 00 00 00"); // another table
    EXPECT_EQ(ask("7E5#13 00 03 00 00 00 00 00"), "7E4#13 00 00 00 00 00 00 00");
    EXPECT_EQ(node().rate(), 125'000);
    EXPECT_EQ(send("605#2B 17 10 00 0A 00 00 00").size(), 2U); // the heartbeat begins
    EXPECT_EQ(ask("7E5#15 64 00 00 00 00 00 00"), "");
    EXPECT_EQ(pass(97ms), Frames{});
    EXPECT_EQ(node().rate(), 125'000);
    EXPECT_EQ(pass(2ms), Frames{});
    EXPECT_EQ(node().rate(), 250'000);
    EXPECT_EQ(pass(98ms), Frames{});
    EXPECT_FALSE(pass(50ms).empty());
    powerCycle();
    EXPECT_EQ(node().rate(), 125'000);
    send("7E5#04 01 00 00 00 00 00 00");
    ask("7E5#13 00 03 00 00 00 00 00");
    ask("7E5#17 00 00 00 00 00 00 00");
    powerCycle();
    EXPECT_EQ(node().rate(), 250'000);
}

TEST_F(NodeLss, AFastScanFindsOneAfterTheOther)
{
    add({.identity = {0x10D, 0x12345678, 0x10002, 0x80000001}});
    add({.identity = {0x10D, 0x12345678, 0x10002, 0x00000001}});
    add({.node = 5, .identity = {0x10D, 0x12345678, 0x10002, 0}}); // it has a number, and keeps silent
    const auto first = scan();
    ASSERT_TRUE(first);
    EXPECT_EQ(*first, (std::array<std::uint32_t, 4>{0x10D, 0x12345678, 0x10002, 0x00000001}));
    EXPECT_EQ(ask("7E5#11 0A 00 00 00 00 00 00"), "7E4#11 00 00 00 00 00 00 00");
    send("7E5#04 00 00 00 00 00 00 00");
    EXPECT_EQ(pass(60ms), Frames{"70A#00"});
    const auto second = scan();
    ASSERT_TRUE(second);
    EXPECT_EQ(*second, (std::array<std::uint32_t, 4>{0x10D, 0x12345678, 0x10002, 0x80000001}));
    EXPECT_EQ(ask("7E5#5D 00 00 00 00 00 00 00"), "7E4#5D 01 00 00 80 00 00 00");
    EXPECT_EQ(ask("7E5#11 0B 00 00 00 00 00 00"), "7E4#11 00 00 00 00 00 00 00");
    send("7E5#04 00 00 00 00 00 00 00");
    EXPECT_EQ(pass(60ms), Frames{"70B#00"});
    EXPECT_FALSE(scan());
}

} // namespace
} // namespace codewheel::canopen
