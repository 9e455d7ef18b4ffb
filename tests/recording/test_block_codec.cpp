// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/block_codec.h"
#include "recording/number_series.h"

#include <gmock/gmock.h>
#include <random>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto mostNegative = std::numeric_limits<std::int64_t>::min();
constexpr auto mostPositive = std::numeric_limits<std::int64_t>::max();

std::optional<std::vector<std::int64_t>> thereAndBack(const std::vector<std::int64_t> &numbers)
{
    QByteArray bytes;
    packSeries(bytes, numbers);
    PackedBytes packed(bytes);
    auto again = unpackSeries(packed, numbers.size());
    EXPECT_TRUE(packed.isAtEnd());
    return again;
}

TEST(NumberSeries, AnyNumbersComeBack)
{
    for (const std::vector<std::int64_t> &numbers :
         std::vector<std::vector<std::int64_t>>{{0},
                                                {-1},
                                                {mostNegative},
                                                {mostPositive, mostNegative, mostPositive, 0},
                                                {1, 1, 1, 1, 1},
                                                {0, 1, 3, 6, 10, 15},
                                                {5, 4, 3, 2, 1, 0, -1}})
        EXPECT_EQ(thereAndBack(numbers), numbers);
}

// Of every width of bits, over several groups, with outliers.
TEST(NumberSeries, RandomNumbersOfEveryWidthComeBack)
{
    std::mt19937_64 random(16);
    for (unsigned width = 1; width <= 64; ++width)
        for (const std::size_t count : {1U, 2U, 31U, 32U, 33U, 34U, 65U, 200U}) {
            std::vector<std::int64_t> numbers(count);
            for (std::int64_t &number : numbers)
                number = static_cast<std::int64_t>(random() >> (64 - width));
            ASSERT_EQ(thereAndBack(numbers), numbers) << width << " bits, " << count;
        }
}

TEST(NumberSeries, ASteadyMotionTakesAlmostNothing)
{
    std::vector<std::int64_t> numbers;
    for (std::int64_t i = 0; i < 1'000; ++i)
        numbers.push_back(37 * i);
    QByteArray bytes;
    packSeries(bytes, numbers);
    EXPECT_LE(bytes.size(), 40);
    bytes.clear();
    for (std::int64_t i = 0; i < 1'000; ++i)
        numbers[static_cast<std::size_t>(i)] = i * i; // steadily faster
    packSeries(bytes, numbers);
    EXPECT_LE(bytes.size(), 420) << "three bits each";
}

TEST(NumberSeries, GrayCodeTakesNoMoreThanWhatItStandsFor)
{
    std::vector<std::int64_t> numbers;
    for (std::int64_t i = 0; i < 1'000; ++i)
        numbers.push_back((34 * i) ^ (17 * i));
    QByteArray bytes;
    packSeries(bytes, numbers);
    EXPECT_LE(bytes.size(), 40);
    EXPECT_EQ(thereAndBack(numbers), numbers);
}

TEST(NumberSeries, ZigzagIsItsOwnInverse)
{
    for (const std::int64_t number :
         {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1}, mostNegative, mostPositive})
        EXPECT_EQ(unzigzag(zigzag(static_cast<std::uint64_t>(number))), static_cast<std::uint64_t>(number));
    EXPECT_EQ(zigzag(static_cast<std::uint64_t>(-2)), 3U);
}

RecordedBlock randomBlock(std::mt19937_64 &random)
{
    const auto below = [&random](std::uint64_t bound) { return random() % bound; };
    RecordedBlock block;
    auto at = Instant(static_cast<std::int64_t>(below(1'000'000)));
    const std::size_t count = 1 + below(below(10) == 0 ? RecordedBlock::most : 100);
    for (std::size_t i = 0; i < count; ++i) {
        const Instant before = at;
        at += Instant(static_cast<std::int64_t>(below(3'000)));
        if (below(20) == 0)
            block.gaps.push_back({i, before + (at - before) / 2});
        block.samples.push_back({at, static_cast<std::int64_t>(random() >> below(64))});
    }
    return block;
}

TEST(BlockCodec, BlocksComeBack)
{
    std::mt19937_64 random(161);
    for (int i = 0; i < 500; ++i) {
        const RecordedBlock block = randomBlock(random);
        ASSERT_EQ(unpackBlock(packBlock(block)), block);
    }
}

TEST(BlockCodec, ItsSummaryIsThatOfAllItsSamples)
{
    const RecordedBlock block{{{1ms, 0b1100}, {2ms, -4}, {3ms, 0b0100}}};
    EXPECT_EQ(block.summary(), (Summary{{-4, 12}, 0b0100, 0xFFFFFFFC}));
}

TEST(BlockCodec, WhatWasDamagedIsNoBlock)
{
    std::mt19937_64 random(162);
    for (int i = 0; i < 200; ++i) {
        const QByteArray bytes = packBlock(randomBlock(random));
        QByteArray flipped = bytes;
        const auto at = static_cast<qsizetype>(random() % static_cast<std::uint64_t>(bytes.size()));
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << (random() % 8)));
        EXPECT_FALSE(unpackBlock(flipped));
        EXPECT_FALSE(unpackBlock(bytes.first(at))) << "cut off";
        EXPECT_FALSE(unpackBlock(bytes + '\0'));
    }
}

QByteArray withChecksum(QByteArray bytes)
{
    const quint16 checksum = qChecksum(bytes);
    bytes.append(static_cast<char>(checksum & 0xFFU));
    return bytes.append(static_cast<char>(checksum >> 8U));
}

// Made by somebody who knows the checksum.
TEST(BlockCodec, ContradictionsAreNoBlock)
{
    const QByteArray whole("\1\1\0\1\2\0\1\6\0", 9);
    ASSERT_TRUE(unpackBlock(withChecksum(whole))) << "one sample, at 1, of 3";
    const std::pair<const char *, QByteArray> wrong[] = {
        {"no such format", QByteArray("\2\1\0\1\2\0\1\6\0", 9)},
        {"no sample", QByteArray("\1\0\0\1\2\0\1\6\0", 9)},
        {"more samples than a block has", QByteArray("\1\x81\x20\0\1\2\0\1\6\0", 10)},
        {"less than it says", QByteArray("\1\2\0\1\2\0\1\6\0", 9)},
        {"more than it says", QByteArray("\1\1\0\1\2\0\1\6\0\0", 10)},
        {"a gap at a sample it does not have", QByteArray("\1\1\1\1\0\1\2\0\1\6\0", 11)},
        {"a gap from before all times", QByteArray("\1\1\1\0\2\1\2\0\1\6\0", 11)},
        {"no such order", QByteArray("\1\1\0\3\2\0\1\6\0", 9)},
        {"wider than 64 bits", QByteArray("\1\2\0\1\2\0\x41", 7) + QByteArray(20, '\0')},
        {"a time that goes back", QByteArray("\1\2\0\1\2\1\0\1\6\0\0", 11)},
        {"a time before all times", QByteArray("\1\1\0\1\1\0\1\6\0", 9)},
        {"a number without an end", QByteArray("\1\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 12)},
    };
    for (const auto &[what, bytes] : wrong)
        EXPECT_FALSE(unpackBlock(withChecksum(bytes))) << what;
    EXPECT_FALSE(unpackBlock({}));
}

TEST(BlockCodec, AnyBytesAreABlockOrNot)
{
    std::mt19937_64 random(163);
    for (int i = 0; i < 20'000; ++i) {
        QByteArray bytes("\1", 1);
        for (std::uint64_t left = random() % 40; left > 0; --left)
            bytes.append(static_cast<char>(random() % (random() % 2 == 0 ? 5 : 256)));
        const auto block = unpackBlock(withChecksum(bytes));
        if (block) {
            ASSERT_EQ(unpackBlock(packBlock(*block)), block);
        }
    }
}

} // namespace
} // namespace codewheel
