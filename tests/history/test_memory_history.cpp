// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/memory_history.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class MemoryHistoryTest : public testing::Test
{
protected:
    // Each millisecond from then on.
    void fill(Instant from, std::size_t count, auto value)
    {
        for (std::size_t index = 0; index < count; ++index)
            ASSERT_TRUE(history.append({from + 1ms * index, value(index)}));
    }
    std::vector<std::int64_t> valuesOf(const TimeSpan &span) const
    {
        std::vector<std::int64_t> values;
        history.forEach(span, [&](const Sample &sample) { values.push_back(sample.value); });
        return values;
    }

    MemoryHistory history;
};

const auto number = [](std::size_t index) { return static_cast<std::int64_t>(index); };
const auto zero = [](std::size_t) { return std::int64_t{0}; };

History::Column column(Extent extent, std::int64_t first, std::int64_t last)
{
    return {.summary = {extent, 0, 0}, .first = first, .last = last};
}

MATCHER_P(isColumn, wanted, "")
{
    return arg && arg->summary.extent == wanted.summary.extent && arg->first == wanted.first &&
           arg->last == wanted.last && arg->hasGap == wanted.hasGap;
}

TEST_F(MemoryHistoryTest, EmptyItKnowsNothing)
{
    EXPECT_FALSE(history.span());
    EXPECT_FALSE(history.at(1s));
    EXPECT_FALSE(history.extent({0s, 1h}));
    EXPECT_FALSE(history.statistics({0s, 1h}));
    EXPECT_THAT(history.columns({0s, 1h}, 2), ElementsAre(std::nullopt, std::nullopt));
    history.interrupt(1s);
    EXPECT_TRUE(history.gaps().empty()) << "nothing was known before";
}

TEST_F(MemoryHistoryTest, GivesTheSamplesOfASpanOverAllBlocks)
{
    fill(0s, 10'000, number);
    EXPECT_THAT(valuesOf({4094ms, 4099ms}), ElementsAre(4094, 4095, 4096, 4097, 4098));
    EXPECT_EQ(valuesOf({0s, 10s}).size(), 10'000U);
    EXPECT_EQ(history.size(), 10'000U);
    EXPECT_EQ(history.count({1s, 9s}), 8'000U);
    EXPECT_EQ(history.count({-1s, 1ms}), 1U);
    EXPECT_EQ(history.count({20s, 30s}), 0U);
    EXPECT_EQ(history.span(), (TimeSpan{0s, 9999001us}));
}

TEST_F(MemoryHistoryTest, TheSampleOfATimeIsTheNewestUpToThen)
{
    fill(1s, 5'000, number);
    EXPECT_FALSE(history.at(999'999us));
    EXPECT_EQ(history.at(1s), (Sample{1s, 0}));
    EXPECT_EQ(history.at(5'096'500us), (Sample{5'096ms, 4'096}));
    EXPECT_EQ(history.at(5'999ms), (Sample{5'999ms, 4'999}));
    EXPECT_FALSE(history.at(1h)) << "nobody knows what will be";
    EXPECT_EQ(history.newest(), (Sample{5'999ms, 4'999}));
    EXPECT_EQ(history.after(5'096'500us), (Sample{5'097ms, 4'097}));
    EXPECT_EQ(history.after(0s), (Sample{1s, 0}));
    EXPECT_FALSE(history.after(5'999ms));
}

TEST_F(MemoryHistoryTest, WhatStandsCostsNothing)
{
    fill(0s, 1'000'000, [](std::size_t) { return std::int64_t{17}; });
    EXPECT_EQ(history.size(), 2U);
    EXPECT_LT(history.bytes(), 2'000U);
    EXPECT_EQ(history.span(), (TimeSpan{0s, 999'999'001us}));
    EXPECT_EQ(history.at(500s)->value, 17);
    fill(1'000s, 2, [](std::size_t) { return std::int64_t{18}; });
    EXPECT_THAT(valuesOf({0s, 1h}), ElementsAre(17, 17, 18, 18));
    EXPECT_EQ(history.at(999'999ms), (Sample{999'999ms, 17})) << "no ramp from there to the next value";
}

TEST_F(MemoryHistoryTest, WhatStandsForANightIsKept)
{
    for (int second = 0; second < 12 * 3'600; ++second)
        ASSERT_TRUE(history.append({1s * second, 17}));
    EXPECT_LT(history.bytes(), 10'000U);
    EXPECT_EQ(history.at(6h)->value, 17);
    EXPECT_EQ(history.span()->to, 12h - 1s + 1us);
}

TEST_F(MemoryHistoryTest, WhatStandsBehindAGapIsNotDrawnThroughIt)
{
    fill(0s, 10, zero);
    history.interrupt(15ms);
    fill(20ms, 10, zero);
    EXPECT_EQ(history.size(), 4U);
    EXPECT_FALSE(history.at(17ms));
    EXPECT_FALSE(history.after(16ms) && history.after(16ms)->at < 20ms);
    EXPECT_EQ(history.at(25ms)->value, 0);
}

TEST_F(MemoryHistoryTest, ASpikeOfOneCycleIsSeenAtEveryZoom)
{
    constexpr std::size_t spike = 123'457;
    fill(0s, 500'000, [](std::size_t index) { return std::int64_t{index == spike ? 8'191 : 17}; });
    for (const std::size_t width : {1U, 7U, 100U, 1'000U, 500'000U}) {
        const auto columns = history.columns({0s, 500s}, width);
        EXPECT_EQ(std::ranges::count_if(
                      columns, [](const auto &one) { return one && one->summary.extent.greatest == 8'191; }),
                  1)
            << width;
    }
}

TEST_F(MemoryHistoryTest, ABitOfOneCycleIsSeenAtEveryZoom)
{
    constexpr std::size_t spike = 123'457;
    fill(0s, 500'000, [](std::size_t index) { return number(index == spike ? 0x4001 : 0xC000 + index % 2); });
    for (const std::size_t width : {1U, 7U, 100U}) {
        const auto columns = history.columns({0s, 500s}, width);
        const auto changes = [&](std::uint32_t bit) {
            return std::ranges::count_if(columns, [bit](const auto &one) {
                return one && (one->summary.ever & ~one->summary.always & bit) != 0;
            });
        };
        EXPECT_EQ(changes(0x8000), 1) << width;
        EXPECT_EQ(changes(0x4000), 0) << width;
        EXPECT_EQ(changes(0x0001), width) << width;
    }
}

TEST_F(MemoryHistoryTest, AColumnTellsWhereItBeginsAndEnds)
{
    fill(0s, 8'000, number);
    EXPECT_THAT(history.columns({-4s, 8s}, 3),
                ElementsAre(std::nullopt, isColumn(column({0, 3'999}, 0, 3'999)),
                            isColumn(column({4'000, 7'999}, 4'000, 7'999))));
}

TEST_F(MemoryHistoryTest, FewSamplesFillFewColumns)
{
    fill(0s, 3, number);
    EXPECT_THAT(history.columns({0s, 3ms}, 6),
                ElementsAre(isColumn(column({0, 0}, 0, 0)), std::nullopt, isColumn(column({1, 1}, 1, 1)),
                            std::nullopt, isColumn(column({2, 2}, 2, 2)), std::nullopt));
}

TEST_F(MemoryHistoryTest, InAGapThereIsNoValue)
{
    fill(0s, 10, number);
    history.interrupt(20ms);
    history.interrupt(25ms);
    EXPECT_EQ(history.at(9ms), (Sample{9ms, 9}));
    EXPECT_FALSE(history.at(15ms)) << "no sample came any more";
    EXPECT_FALSE(history.at(20ms));
    EXPECT_FALSE(history.newest());
    EXPECT_FALSE(history.after(15ms));
    fill(30ms, 10, number);
    EXPECT_THAT(history.gaps(), ElementsAre(History::Gap{20ms, 30ms}));
    EXPECT_FALSE(history.at(29ms));
    EXPECT_EQ(history.at(30ms), (Sample{30ms, 0}));
}

TEST_F(MemoryHistoryTest, AGapBreaksTheColumnBehindIt)
{
    fill(0s, 10, number);
    history.interrupt(15ms);
    fill(40ms, 10, number);
    const auto columns = history.columns({0s, 60ms}, 6);
    ASSERT_TRUE(columns[0] && columns[4]);
    EXPECT_FALSE(columns[0]->hasGap);
    EXPECT_FALSE(columns[1]);
    EXPECT_TRUE(columns[4]->hasGap);
    EXPECT_TRUE(history.columns({0s, 60ms}, 1)[0]->hasGap) << "inside it";
    EXPECT_FALSE(history.columns({41ms, 60ms}, 1)[0]->hasGap) << "before what is seen";
}

TEST_F(MemoryHistoryTest, WhatComesTooLateIsNotKept)
{
    fill(1s, 10, number);
    EXPECT_FALSE(history.append({1s, 5}));
    EXPECT_TRUE(history.append({1'009ms, 5})) << "the bus may answer twice in a microsecond";
    history.interrupt(2s);
    EXPECT_FALSE(history.append({1'500ms, 5}));
    EXPECT_EQ(history.size(), 11U);
}

TEST_F(MemoryHistoryTest, StatisticsAreThoseOfTheSpan)
{
    fill(0s, 1'000, zero);
    fill(1s, 6'000, [](std::size_t index) { return std::int64_t{index % 2 == 0 ? 10 : 20}; });
    const auto statistics = history.statistics({1s, 7s});
    ASSERT_TRUE(statistics);
    EXPECT_EQ(statistics->extent, (Extent{10, 20}));
    EXPECT_NEAR(statistics->mean, 15, 0.001);
    EXPECT_NEAR(statistics->deviation, 5, 0.001);
    EXPECT_EQ(statistics->known, 5'999ms);
}

TEST_F(MemoryHistoryTest, AValueCountsForAsLongAsItStands)
{
    fill(0s, 3'000, zero);
    fill(3s, 1'001, [](std::size_t) { return std::int64_t{8}; });
    const auto statistics = history.statistics({0s, 4s});
    ASSERT_TRUE(statistics);
    EXPECT_DOUBLE_EQ(statistics->mean, 2);
    EXPECT_DOUBLE_EQ(statistics->deviation, std::sqrt(12));
    EXPECT_DOUBLE_EQ(history.statistics({500ms, 1'500ms})->mean, 0) << "between the samples kept";
    EXPECT_EQ(history.statistics({500ms, 1'500ms})->known, 1s);
}

// Beside the plain way of going through all of them.
TEST_F(MemoryHistoryTest, StatisticsOfAnySpanAreThoseOfItsMicroseconds)
{
    std::mt19937 random(7);
    std::vector<std::optional<std::int64_t>> values; // at each microsecond
    std::optional<std::int64_t> value;
    for (int at = 0; at < 20'000; ++at) {
        if (random() % 3 == 0) {
            value = static_cast<std::int64_t>(random() % 5) - 2'000;
            history.append({Instant(at), *value});
        } else if (random() % 50 == 0 && value) {
            value.reset();
            history.interrupt(Instant(at));
        } else if (value) {
            history.append({Instant(at), *value}); // stands
        }
        values.push_back(value);
    }
    for (int round = 0; round < 200; ++round) {
        const auto from = random() % values.size();
        const auto to = std::min<std::size_t>(from + 1 + random() % 9'000, values.size() - 1);
        double sum = 0;
        double squares = 0;
        double count = 0;
        for (auto at = from; at < to; ++at)
            if (values[at]) {
                sum += static_cast<double>(*values[at]);
                squares += static_cast<double>(*values[at] * *values[at]);
                ++count;
            }
        const auto statistics = history.statistics({Instant(from), Instant(to)});
        if (count == 0)
            continue;
        ASSERT_TRUE(statistics);
        ASSERT_EQ(statistics->known, Instant(static_cast<std::int64_t>(count))) << from << " " << to;
        ASSERT_NEAR(statistics->mean, sum / count, 1e-6) << from << " " << to;
        ASSERT_NEAR(statistics->deviation,
                    std::sqrt(std::max(squares / count - sum / count * (sum / count), 0.0)), 1e-4);
    }
}

TEST_F(MemoryHistoryTest, AGapCountsForNothing)
{
    fill(0s, 1'001, zero);
    history.interrupt(1s);
    fill(9s, 1'001, [](std::size_t) { return std::int64_t{8}; });
    const auto statistics = history.statistics({0s, 20s});
    ASSERT_TRUE(statistics);
    EXPECT_DOUBLE_EQ(statistics->mean, 4);
    EXPECT_EQ(statistics->known, 2s);
    EXPECT_FALSE(history.statistics({2s, 3s}));
}

TEST_F(MemoryHistoryTest, StatisticsOfLargeValuesKeepWhatIsSmall)
{
    fill(0s, 4'000,
         [](std::size_t index) { return std::int64_t{4'000'000'000} + (index % 2 == 0 ? 1 : -1); });
    EXPECT_NEAR(history.statistics({0s, 4s})->deviation, 1, 1e-3);
}

TEST_F(MemoryHistoryTest, TheOldestMakeRoom)
{
    fill(0s, 2'000, number);
    history.interrupt(2s);
    fill(3s, 8'000, number);
    const std::size_t before = history.bytes();
    EXPECT_EQ(history.oldestBlockEnd(), 5'095ms);
    history.forgetOldest();
    EXPECT_LT(history.bytes(), before);
    EXPECT_EQ(history.size(), 10'000U - SampleBlock::capacity);
    EXPECT_TRUE(history.gaps().empty());
    EXPECT_EQ(history.span()->from, 5'096ms);
    EXPECT_THAT(valuesOf({0s, 5'098ms}), ElementsAre(2'096, 2'097));
    history.forgetOldest();
    history.forgetOldest();
    EXPECT_EQ(history.size(), 10'000U - 2 * SampleBlock::capacity) << "the newest block stays";
    EXPECT_FALSE(history.oldestBlockEnd());
}

TEST_F(MemoryHistoryTest, AMillionSamplesCostNoMoreThanNineBytesEach)
{
    fill(0s, 1'000'000, number);
    EXPECT_LE(static_cast<double>(history.bytes()) / 1e6, 9.0);
}

} // namespace
} // namespace codewheel
