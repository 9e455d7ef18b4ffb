// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_mail.h"
#include "bus/value_tap.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace codewheel {

void PrintTo(const DeviceValues &position, std::ostream *out)
{
    *out << position.device << " at " << position.shown.at.count() << ": "
         << position.shown.position.value_or(-1);
}

namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

Reading reading(Instant at, std::optional<std::int64_t> position)
{
    Reading reading;
    reading.at = at;
    reading.state = position ? EncoderState::operation : EncoderState::parameterization;
    reading.position = position;
    return reading;
}

auto shows(std::size_t device, Instant at, std::optional<std::int64_t> position)
{
    return testing::AllOf(testing::Field(&DeviceValues::device, device),
                          testing::Field(&DeviceValues::shown,
                                         testing::AllOf(testing::Field(&ShownValues::at, at),
                                                        testing::Field(&ShownValues::position, position))));
}

class ValueTapTest : public testing::Test
{
protected:
    ValueTap tap;
};

TEST_F(ValueTapTest, EachCycleIsNotedAlsoWhereNothingMoves)
{
    tap.look(0, reading(1ms, 17), true, 1ms);
    tap.look(0, reading(2ms, 17), true, 2ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 1ms, 17), shows(0, 2ms, 17)));
    tap.clear();
    EXPECT_THAT(tap.noted(), IsEmpty());
}

// A reading that is not there yet has that time, too.
TEST_F(ValueTapTest, WhatComesWithTheOpeningIsNoted)
{
    tap.look(0, reading(0ms, {}), true, 0ms);
    tap.look(0, reading(0ms, 17), true, 0ms);
    tap.look(0, reading(0ms, 17), true, 5ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 0ms, 17)));
}

TEST_F(ValueTapTest, AnAnswerIsNotedOnce)
{
    tap.look(3, reading(1ms, 17), true, 1ms);
    tap.look(3, reading(1ms, 17), true, 5ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(3, 1ms, 17)));
}

TEST_F(ValueTapTest, TheEndOfPositionsIsNotedOnce)
{
    tap.look(0, reading(1ms, 17), true, 1ms);
    tap.look(0, reading(2ms, {}), true, 2ms);
    tap.look(0, reading(3ms, {}), true, 3ms);
    tap.look(0, reading(4ms, 18), true, 4ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 1ms, 17), shows(0, 2ms, {}), shows(0, 4ms, 18)));
}

// The computer was busy, or the bus.
TEST_F(ValueTapTest, WhatWasNotSeenIsAGap)
{
    for (const Instant at : {1000ms, 1100ms, 1200ms, 5500ms, 5600ms, 6500ms})
        tap.look(0, reading(at, at.count()), true, at);
    const auto noted = [](Instant at) { return shows(0, at, at.count()); };
    EXPECT_THAT(tap.noted(), ElementsAre(noted(1000ms), noted(1100ms), noted(1200ms), shows(0, 1300ms, {}),
                                         noted(5500ms), noted(5600ms), noted(6500ms)));
}

TEST_F(ValueTapTest, WhileTheComputerSleptNothingWasSeen)
{
    tap.look(0, reading(1ms, 17), true, 1ms);
    tap.look(2, reading(2ms, 19), true, 2ms);
    tap.interrupt();
    tap.interrupt();
    tap.look(0, reading(1ms, 17), true, 3ms);
    tap.look(0, reading(4ms, 18), true, 4ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 1ms, 17), shows(2, 2ms, 19), shows(0, 1ms, {}),
                                         shows(2, 2ms, {}), shows(0, 4ms, 18)));
}

TEST_F(ValueTapTest, AnotherPaceIsNone)
{
    Instant at = 0s;
    for (const Instant pace : {100ms, 100ms, 5000ms, 5000ms, 5000ms, 5000ms, 100ms, 100ms})
        tap.look(0, reading(at += pace, 17), true, at);
    EXPECT_EQ(std::ranges::count_if(tap.noted(), [](const auto &each) { return !each.shown.position; }), 2)
        << "until it is known to be the usual one";
}

TEST_F(ValueTapTest, WhatStandsThereWhileTheBusIsStoppedIsNoPosition)
{
    tap.look(0, reading(1ms, 17), true, 1ms);
    tap.look(0, reading(1ms, 17), false, 2ms);
    tap.look(0, reading(1ms, 17), true, 9ms);
    tap.look(0, reading(10ms, 17), true, 10ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 1ms, 17), shows(0, 2ms, {}), shows(0, 10ms, 17)));
}

TEST_F(ValueTapTest, WordsGoOnWhereNoPositionIsShown)
{
    const ExchangedWords words{.in = 0xC2000000, .out = 0x020000FF};
    tap.look(0, reading(1ms, 17), true, 1ms, words);
    tap.look(0, reading(2ms, {}), true, 2ms, words);
    tap.look(0, reading(2ms, {}), false, 3ms, words);
    ASSERT_EQ(tap.noted().size(), 3U);
    EXPECT_EQ(tap.noted()[0].shown, (ShownValues{.at = 1ms, .position = 17, .words = words}));
    EXPECT_EQ(tap.noted()[1].shown, (ShownValues{.at = 2ms, .words = words}));
    EXPECT_EQ(tap.noted()[2].shown, (ShownValues{.at = 3ms}));
}

TEST_F(ValueTapTest, InCamModeThereAreCams)
{
    Reading cams = reading(1ms, {});
    cams.cams = {.on = 0x81, .positionPart = 5};
    tap.look(0, cams, true, 1ms);
    EXPECT_THAT(tap.noted(), ElementsAre(shows(0, 1ms, {})));
    EXPECT_EQ(tap.noted().front().shown.cams, 0x81);
}

TEST_F(ValueTapTest, ADoubtfulPositionIsNone)
{
    Reading doubtful = reading(1ms, 17);
    doubtful.suspect = true;
    tap.look(0, doubtful, true, 1ms);
    Reading magnetLost = reading(2ms, 17);
    magnetLost.state = EncoderState::error;
    tap.look(0, magnetLost, true, 2ms);
    EXPECT_THAT(tap.noted(), IsEmpty());
}

TEST(ValueRoundTest, SortsByDevice)
{
    ValueRound round;
    const auto &sorted = round.sort({{1, {1ms, 10}}, {0, {1ms, 20}}, {1, {2ms, 11}}}, true);
    EXPECT_THAT(sorted, ElementsAre(ElementsAre(ShownValues{1ms, 20}),
                                    ElementsAre(ShownValues{1ms, 10}, ShownValues{2ms, 11})));
    EXPECT_THAT(round.sort({{1, {3ms, 12}}}, true),
                ElementsAre(IsEmpty(), ElementsAre(ShownValues{3ms, 12})));
}

TEST(ValueRoundTest, BehindWhatWasDroppedNoDeviceShowsAPosition)
{
    ValueRound round;
    EXPECT_THAT(round.sort({{0, {1ms, 10}}, {1, {2ms, 11}}}, false),
                ElementsAre(ElementsAre(ShownValues{1ms, 10}, ShownValues{2ms, {}}),
                            ElementsAre(ShownValues{2ms, 11}, ShownValues{2ms, {}})));
}

TEST(BusMailTest, WhatNobodyTakesIsDroppedAndCounted)
{
    struct Event
    {
        bool isRow() const { return false; }
    };
    struct Snapshot
    {};
    using Mail = BusMail<int, Event, Snapshot>;
    Mail mail;
    const std::vector<DeviceValues> cycle(1'000, {0, {1ms, 5}});
    for (std::size_t told = 0; told < Mail::maximumShown; told += cycle.size())
        mail.note(cycle);
    mail.note(cycle);
    mail.note({{0, {2ms, 6}}});
    Mail::Shown taken;
    mail.takeShown(taken);
    EXPECT_EQ(taken.shown.size(), Mail::maximumShown);
    EXPECT_EQ(taken.dropped, 1'001U);
    mail.note({{0, {3ms, 7}}});
    mail.takeShown(taken);
    EXPECT_THAT(taken.shown, ElementsAre(shows(0, 3ms, 7)));
    EXPECT_EQ(taken.dropped, 0U);
}

} // namespace
} // namespace codewheel
