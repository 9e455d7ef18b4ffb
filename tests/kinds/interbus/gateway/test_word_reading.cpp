// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/word_reading.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

SendingEncoder senderNamed(const char16_t *key, std::optional<std::int64_t> totalRange = std::nullopt)
{
    static const Catalog catalog = Catalog::builtIn();
    return {*catalog.find(key), totalRange};
}

std::vector<Word> wordsOf(const std::vector<WordReading> &readings)
{
    std::vector<Word> words;
    words.reserve(readings.size());
    for (const WordReading &reading : readings)
        words.push_back(reading.word);
    return words;
}

std::vector<Plausibility> judgementsOf(const std::vector<WordReading> &readings)
{
    std::vector<Plausibility> all;
    all.reserve(readings.size());
    for (const WordReading &reading : readings)
        all.push_back(reading.plausibility);
    return all;
}

TEST(WordReading, AWordHasFourOrders)
{
    const std::vector<Register> registers{0x0102, 0x0304};
    const auto readings = wordReadings(registers, {});
    EXPECT_EQ(wordsOf(readings), (std::vector<Word>{0x0102'0304, 0x0304'0102, 0x0201'0403, 0x0403'0201}));
    EXPECT_EQ(wordOrderName(readings[3].order), QStringLiteral("DCBA"));
}

TEST(WordReading, AWordOfOneRegisterHasTwo)
{
    const std::vector<Register> registers{0x0102};
    const auto readings = wordReadings(registers, senderNamed(u"fraba-ocd-ib-k1"));
    EXPECT_EQ(wordsOf(readings), (std::vector<Word>{0x0102, 0x0201}));
    EXPECT_EQ(readingIn(readings, WordOrder::cdab)->word, 0x0102U);
}

TEST(WordReading, OfAConfirmationOnlyTheRightOrderIsPlausible)
{
    using enum Plausibility;
    const std::vector<Register> registers{0xC200, 0x00FF};
    const auto readings = wordReadings(registers, senderNamed(u"fraba-ocd-ib"));
    // 00FFC200 is a position of an encoder of which no total range is known.
    EXPECT_EQ(judgementsOf(readings), (std::vector{fits, fits, fits, cannotBe}));
    EXPECT_EQ(judgementsOf(wordReadings(registers, senderNamed(u"fraba-ocd-ib", 4'096))),
              (std::vector{fits, unlikely, unlikely, cannotBe}));
}

TEST(WordReading, APositionIsNotBeyondTheTotalRange)
{
    using enum Plausibility;
    const std::vector<Register> registers{0x0000, 0x1234};
    EXPECT_EQ(judgementsOf(wordReadings(registers, senderNamed(u"fraba-ocd-ib", 0x2000))),
              (std::vector{fits, cannotBe, unlikely, cannotBe}));
    EXPECT_EQ(judgementsOf(wordReadings(registers, senderNamed(u"fraba-ocd-ib", 0x1234))).front(), unlikely);
    EXPECT_EQ(judgementsOf(wordReadings(registers, senderNamed(u"fraba-ocd-ib", 0x1235))).front(), fits);
}

TEST(WordReading, ASignedPositionCountsFromTheMiddle)
{
    const std::vector<Register> minusOne{0x01FF, 0xFFFF};
    EXPECT_EQ(judgementsOf(wordReadings(minusOne, senderNamed(u"baumer-gxp6w", 1'000))).front(),
              Plausibility::fits);
    EXPECT_EQ(judgementsOf(wordReadings(minusOne, senderNamed(u"fraba-ocd-ib", 1'000))).front(),
              Plausibility::unlikely); // no such coding
}

TEST(WordReading, WhatNoDescriptionSaysIsNotJudged)
{
    const std::vector<Register> registers{0xFFFF, 0xFFFF};
    EXPECT_EQ(judgementsOf(wordReadings(registers, {})), (std::vector(4, Plausibility::notKnown)));
    EXPECT_TRUE(wordReadings({}, {}).empty());
}

} // namespace
} // namespace codewheel
