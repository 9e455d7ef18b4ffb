// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/encoder_history.h"
#include "recording/recording_trigger.h"
#include "tests/support/places.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Place here = "1.0"_ring;

struct ValueCase
{
    const char *what;
    RecordingTrigger trigger;
    std::vector<std::optional<std::int64_t>> values; // one each millisecond
    std::optional<Instant> fires;
};

ShownValues shownOf(const RecordingTrigger &trigger, Instant at, std::optional<std::int64_t> value)
{
    ShownValues shown{.at = at};
    if (!value)
        return shown;
    const Channel channel = std::holds_alternative<BitTrigger>(trigger)
                                ? std::get<BitTrigger>(trigger).channel
                                : std::get<ThresholdTrigger>(trigger).channel;
    const auto word = static_cast<Word>(*value);
    if (channel == Channel::position)
        shown.position = value;
    else if (channel == Channel::speed)
        shown.stepsPerSecond = static_cast<double>(*value) / speedUnits;
    else if (channel == Channel::cams)
        shown.cams = static_cast<std::uint8_t>(*value);
    else
        shown.words = channel == Channel::in ? ExchangedWords{.in = word} : ExchangedWords{.out = word};
    return shown;
}

TEST(RecordingTrigger, Values)
{
    const auto unknown = std::nullopt;
    const ValueCase cases[] = {
        {"a bit rises", BitTrigger{here, Channel::in, 31, true}, {0, 0, 0x80000000}, 2ms},
        {"another bit", BitTrigger{here, Channel::in, 31, true}, {0, 0x7FFFFFFF}, {}},
        {"a bit falls", BitTrigger{here, Channel::out, 0, false}, {1, 3, 2}, 2ms},
        {"it rises, and should fall", BitTrigger{here, Channel::out, 0, false}, {0, 1}, {}},
        {"it was there from the beginning", BitTrigger{here, Channel::in, 0, true}, {1, 1}, {}},
        {"it was there already once it is known",
         BitTrigger{here, Channel::in, 0, true},
         {0, unknown, 1},
         {}},
        {"a cam goes on", BitTrigger{here, Channel::cams, 3, true}, {0, 8, 0}, 1ms},
        {"reached from below", ThresholdTrigger{here, Channel::position, 100, true}, {99, 100}, 1ms},
        {"leapt over", ThresholdTrigger{here, Channel::position, 100, true}, {-5, 4000}, 1ms},
        {"not reached", ThresholdTrigger{here, Channel::position, 100, true}, {5, 99}, {}},
        {"only after it came back",
         ThresholdTrigger{here, Channel::position, 100, true},
         {150, 160, 90, 100},
         3ms},
        {"below", ThresholdTrigger{here, Channel::position, 100, false}, {100, 99}, 1ms},
        {"speed", ThresholdTrigger{here, Channel::speed, -2'000, false}, {0, -1'999, -2'001}, 2ms},
    };
    for (const ValueCase &one : cases) {
        ShownSeries series;
        for (std::size_t i = 0; i < one.values.size(); ++i)
            series.push_back(shownOf(one.trigger, 1ms * i, one.values[i]));
        TriggerWatch watch(one.trigger);
        EXPECT_EQ(watch.take(here, series), one.fires) << one.what;
        TriggerWatch inPieces(one.trigger);
        std::optional<Instant> fired;
        for (const ShownValues &shown : series)
            if (const auto at = inPieces.take(here, {shown}); at && !fired)
                fired = at;
        EXPECT_EQ(fired, one.fires) << one.what << ", value by value";
        TriggerWatch elsewhere(one.trigger);
        EXPECT_EQ(elsewhere.take("2.0"_ring, series), std::nullopt) << one.what << ", elsewhere";
    }
}

TEST(RecordingTrigger, Messages)
{
    const Message fault{.place = here, .severity = Severity::fault, .id = MessageId::deviceFault};
    const Message noted{.place = here, .severity = Severity::information, .id = MessageId::busStarted};
    const Message ofProgram{.severity = Severity::fault};
    struct Case
    {
        const char *what;
        MessageTrigger trigger;
        const Message *message;
        bool fires;
    };
    const Case cases[] = {
        {"a fault anywhere", {}, &fault, true},
        {"no fault", {}, &noted, false},
        {"any message", {.least = Severity::information}, &noted, true},
        {"at its place", {.place = here}, &fault, true},
        {"at another place", {.place = "2.0"_ring}, &fault, false},
        {"on its bus", {.place = Place{firstBus, {}}}, &fault, true},
        {"on another bus", {.place = Place{firstLine, {}}}, &fault, false},
        {"of the program", {.place = here}, &ofProgram, false},
    };
    for (const Case &one : cases) {
        EXPECT_EQ(TriggerWatch(one.trigger).take(RecordedMessage{7s, *one.message}).has_value(), one.fires)
            << one.what;
        TriggerWatch watch(one.trigger);
        EXPECT_FALSE(watch.take(here, {{.at = 1s, .position = 1}}));
    }
}

TEST(RecordingExtent, LiesAroundTheTrigger)
{
    EXPECT_EQ((RecordingExtent{5s, 10s}.around(60s)), (TimeSpan{55s, 70s}));
    EXPECT_EQ((RecordingExtent{5s, {}}.around(1s)), (TimeSpan{0s, Instant::max()}));
}

TEST(RecordingExtent, WhatWasBeforeComesFromTheHistory)
{
    EncoderHistory history;
    for (int i = 0; i < 10; ++i)
        history.add({.at = 1ms * i, .position = i / 5});
    history.add({.at = 20ms});
    const auto past = pastOf(here, history, {3ms, 30ms});
    ASSERT_EQ(past.size(), 1U);
    EXPECT_EQ(past[0].channel, Channel::position);
    EXPECT_THAT(past[0].samples,
                testing::ElementsAre(Sample{3ms, 0}, Sample{4ms, 0}, Sample{5ms, 1}, Sample{9ms, 1}));
    ASSERT_EQ(past[0].gaps.size(), 1U);
    EXPECT_EQ(past[0].gaps[0].from, Instant(20ms));
    EXPECT_TRUE(pastOf(here, EncoderHistory(), {0s, 1s}).empty());
}

} // namespace
} // namespace codewheel
