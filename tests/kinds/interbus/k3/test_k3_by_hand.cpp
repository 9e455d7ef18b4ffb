// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(K3ByHand, EachWordWaitsForTheUser)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(
        table.begin(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    table.repeat(100, {0x0000'0000, pos});
    EXPECT_TRUE(table.progress().waitsForUser);
    EXPECT_EQ(table.progress().steps.size(), 3u);
    EXPECT_EQ(table.progress().steps[0].out, 0x0200'00FFu);

    table.driver().proceed();
    table.play({{0x0000'0000, pos}, {0x0200'00FF, pos}});
    EXPECT_FALSE(table.progress().waitsForUser);
    table.play({{0x0200'00FF, 0xC200'00FF}});
    table.repeat(5000, {0x0200'00FF, 0xC200'00FF}); // thinking does not time out
    EXPECT_TRUE(table.progress().waitsForUser);
    EXPECT_EQ(table.progress().confirmed, (ParameterValues{{Parameter::steps, 255}}));

    table.driver().proceed();
    table.play(
        {{0x0200'00FF, 0xC200'00FF}, {0x8000'0000, 0xC200'00FF}, {0x8000'0000, 384}, {0x8000'0000, 384}});
    table.driver().proceed();
    table.play({{0x8000'0000, 384}, {0x0000'0000, 384}, {0x0000'0000, 384}});
    ASSERT_TRUE(table.outcome());
    EXPECT_TRUE(table.outcome()->result);
}

TEST(K3ByHand, ProceedBeforeItIsAskedForDoesNotSkipAQuestion)
{
    DriverTable table(u"baumer-gxp6w");
    ASSERT_TRUE(
        table.begin(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    table.driver().proceed();
    table.repeat(10, {0x0000'0000, pos});
}

TEST(K3ByHand, AnErrorWhileTheUserThinksStopsTheJob)
{
    DriverTable table(u"fraba-ocd-ib");
    ASSERT_TRUE(
        table.begin(WriteParameters{.values = {{Parameter::direction, 4}}, .previous = {}}, Pace::byHand));
    table.play({{0x0000'0000, pos}});
    table.driver().proceed();
    table.play({{0x0000'0000, pos}, {0x0600'0004, 0xC600'0004}});
    table.repeat(100, {0x0600'0004, 0xC600'0004});
    table.play({{0x0600'0004, 0x8200'0000}, {0x0600'0004, 0x8200'0000}});
    table.repeat(3, {0x0000'0000, 0x8200'0000});
    ASSERT_TRUE(table.outcome());
    ASSERT_FALSE(table.outcome()->result);
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::wrongParameterData);
}

} // namespace
} // namespace codewheel
