// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/driver_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

WriteParameters lengthAndDirection()
{
    return {.values = {{Parameter::measuringLength, 5'000}, {Parameter::direction, 1}}, .previous = {}};
}

TEST(La66Cancel, BeforeTheFirstCycleItEndsWithoutAStep)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.driver().cancel(OnCancel::leaveAsIs, {});
    table.play({{0, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::cancelled);
    EXPECT_TRUE(table.progress().steps.empty());
}

TEST(La66Cancel, BeforeTheServiceBitNothingHappens)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}});
    table.driver().cancel(OnCancel::restorePrevious, {});
    table.repeat(2, {0x4200'1388, pos});
    table.play({{0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(table.outcome()->eepromWrites, 0);
}

TEST(La66Cancel, IfNothingWasTakenAWriteThatWasAskedForGoesOn)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}});
    EXPECT_FALSE(table.progress().hasTaken);
    table.play({{0x4200'1388, pos}, {0xC200'1388, pos}});
    EXPECT_TRUE(table.progress().hasTaken);
    table.driver().cancel(OnCancel::ifNothingTaken, {});
    table.play({{0xC200'1388, 0xC200'1388}, {0x4200'1388, 0xC200'1388}, {0x4200'1388, pos}});
    EXPECT_FALSE(table.outcome());
    EXPECT_TRUE(table.driver().busy());
}

TEST(La66Cancel, AServiceOnItsWayIsWaitedForAndItsHandshakeIsFinished)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, pos}});
    table.driver().cancel(OnCancel::leaveAsIs, {});
    table.play({{0xC200'1388, pos},
                {0xC200'1388, 0xC200'1388},
                {0x4200'1388, 0xC200'1388},
                {0x4200'1388, 0xC200'1388},
                {0x4200'1388, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::measuringLength, 5'000}}));
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::operation);
    EXPECT_EQ(table.known(Parameter::measuringLength), 5'000);
}

TEST(La66Cancel, TheRestOfTheWordStandsUntilTheEncoderIsInNormalMode)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'1388}});
    table.play({{0x4200'1388, 0xC200'1388}});
    table.driver().cancel(OnCancel::leaveAsIs, {});
    table.repeat(10, {0x4200'1388, 0xC200'1388});
    table.play({{0x4200'1388, pos}, {0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
}

TEST(La66Cancel, OldValuesGoBackWhereTheyAreKnown)
{
    DriverTable table(La66Timing{});
    table.tell(Parameter::measuringLength, 50'000);
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'1388}});
    EXPECT_TRUE(table.progress().canRestore);
    EXPECT_EQ(table.progress().confirmed, (ParameterValues{{Parameter::measuringLength, 5'000}}));
    table.driver().cancel(OnCancel::restorePrevious, {});
    table.play({{0x4200'1388, pos},
                {0x4200'1388, pos},
                {0x0000'0000, pos},
                {0x4200'C350, pos},
                {0x4200'C350, pos},
                {0xC200'C350, 0xC200'C350},
                {0x4200'C350, pos},
                {0x0200'0000, pos},
                {0x0200'0000, pos},
                {0x8200'0000, 0x8200'C350},
                {0x0200'0000, pos},
                {0x0000'0000, pos},
                {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::cancelled);
    EXPECT_EQ(table.outcome()->eepromWrites, 2);
    EXPECT_EQ(table.known(Parameter::measuringLength), 50'000);
    EXPECT_EQ(table.outcome()->restored, Evidence::read);
    EXPECT_EQ(table.outcome()->written, (ParameterValues{{Parameter::measuringLength, 50'000}}));
}

TEST(La66Cancel, WithoutOldValuesNothingIsPutInTheirPlace)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'1388}});
    table.play({{0x4200'1388, pos}});
    EXPECT_FALSE(table.progress().canRestore);
    table.driver().cancel(OnCancel::restorePrevious, {});
    table.repeat(2, {0x0200'0000, pos});
    table.play({{0x0000'0000, pos}, {0x0000'0000, pos}});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->restored, std::nullopt);
    EXPECT_EQ(table.outcome()->eepromWrites, 1);
}

TEST(La66Cancel, AStopEndsTheJobWhereItStands)
{
    DriverTable table(La66Timing{});
    ASSERT_TRUE(table.begin(lengthAndDirection()));
    table.play({{0, pos}, {0x4200'1388, pos}, {0x4200'1388, pos}, {0xC200'1388, 0xC200'1388}});
    table.driver().stop({RefusalKind::stopped, RefusalId::alarmStop, {}}, {});
    ASSERT_TRUE(table.outcome());
    EXPECT_EQ(table.outcome()->result.error().id, RefusalId::alarmStop);
    EXPECT_EQ(table.outcome()->leftIn, EncoderState::service);
    EXPECT_FALSE(table.driver().busy());
}

} // namespace
} // namespace codewheel
