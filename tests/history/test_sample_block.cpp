// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/sample_block.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

SampleBlock fullOf(const std::vector<std::int64_t> &values)
{
    SampleBlock block({5s, values.front()});
    for (std::size_t index = 1; index < values.size(); ++index)
        block.append({5s + 1ms * index, values[index]});
    return block;
}

TEST(SampleBlockTest, GivesBackWhatItWasGiven)
{
    const SampleBlock block = fullOf({12'345, 0, 0xC20000FF, 8'191});
    ASSERT_EQ(block.size(), 4U);
    EXPECT_EQ(block[0], (Sample{5s, 12'345}));
    EXPECT_EQ(block[2], (Sample{5s + 2ms, 0xC20000FF}));
    EXPECT_EQ(block.last(), 5s + 3ms);
}

TEST(SampleBlockTest, HoldsEachWordBesideEachOther)
{
    SampleBlock block({0s, 0xFFFFFFFF});
    EXPECT_TRUE(block.takes({1ms, 0}));
    EXPECT_FALSE(block.takes({1ms, -1}));
    EXPECT_FALSE(block.takes({1ms, 0x100000000}));
}

TEST(SampleBlockTest, HoldsNegativeValuesBesidePositiveOnes)
{
    SampleBlock block({0s, -600});
    ASSERT_TRUE(block.takes({1ms, 600}));
    block.append({1ms, 600});
    EXPECT_EQ(block[0].value, -600);
    EXPECT_EQ(block.summary().extent, (Extent{-600, 600}));
}

TEST(SampleBlockTest, EndsWhereItsTimeOrItsRoomEnds)
{
    const SampleBlock early({0s, 1});
    EXPECT_TRUE(early.takes({71min, 1}));
    EXPECT_FALSE(early.takes({72min, 1}));
    EXPECT_TRUE(fullOf(std::vector<std::int64_t>(SampleBlock::capacity - 1, 7)).takes({1h, 7}));
    EXPECT_FALSE(fullOf(std::vector<std::int64_t>(SampleBlock::capacity, 7)).takes({1h, 7}));
}

TEST(SampleBlockTest, TheLastOneMayStandLonger)
{
    SampleBlock block = fullOf({1, 2});
    block.holdUntil(6s);
    EXPECT_EQ(block.last(), 6s);
    EXPECT_EQ(block[1], (Sample{6s, 2}));
    EXPECT_EQ(block[0], (Sample{5s, 1}));
}

TEST(SampleBlockTest, FewSamplesTakeLittleMemory)
{
    EXPECT_LT(fullOf({1, 2}).bytes(), 1'000U);
}

TEST(SampleBlockTest, FindsATime)
{
    const SampleBlock block = fullOf({1, 2, 3});
    EXPECT_EQ(block.indexAt(0s), 0U);
    EXPECT_EQ(block.indexAt(5s), 0U);
    EXPECT_EQ(block.indexAt(5s + 1us), 1U);
    EXPECT_EQ(block.indexAt(5s + 2ms), 2U);
    EXPECT_EQ(block.indexAt(5s + 2001us), 3U);
    EXPECT_EQ(block.indexAt(Instant::max()), 3U);
}

// Beside the plain way of going through all of them.
TEST(SampleBlockTest, TheSummaryOfAnyRangeIsThatOfItsSamples)
{
    std::mt19937 random(1);
    std::vector<std::int64_t> values(SampleBlock::capacity);
    std::ranges::generate(values, [&] { return static_cast<std::int64_t>(random()); });
    const SampleBlock block = fullOf(values);
    for (int round = 0; round < 2'000; ++round) {
        auto begin = random() % values.size();
        auto end = random() % values.size();
        if (round % 4 == 0)
            end = std::min<std::size_t>(begin + random() % 40, values.size());
        if (begin > end)
            std::swap(begin, end);
        if (begin == end)
            continue;
        const auto [least, greatest] =
            std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                values.begin() + static_cast<std::ptrdiff_t>(end));
        std::uint32_t always = ~0U;
        std::uint32_t ever = 0;
        for (auto index = begin; index < end; ++index) {
            always &= static_cast<std::uint32_t>(values[index]);
            ever |= static_cast<std::uint32_t>(values[index]);
        }
        ASSERT_EQ(block.summary(begin, end), (Summary{{*least, *greatest}, always, ever}))
            << begin << " to " << end;
    }
}

TEST(SampleBlockTest, TheExtentIsRightWhileItFills)
{
    SampleBlock block({0s, 500});
    for (int index = 1; index < 1'000; ++index) {
        block.append({1ms * index, index % 2 == 0 ? 500 + index : 500 - index / 2});
        ASSERT_EQ(block.summary().extent,
                  (Extent{500 - (index - 1 + index % 2) / 2, index < 2 ? 500 : 500 + index - index % 2}))
            << index;
    }
}

TEST(SampleBlockTest, AValueAndItsTimeCostNoMoreThanNineBytes)
{
    const SampleBlock block = fullOf(std::vector<std::int64_t>(SampleBlock::capacity, 7));
    EXPECT_LE(static_cast<double>(block.bytes()) / SampleBlock::capacity, 9.0);
}

} // namespace
} // namespace codewheel
