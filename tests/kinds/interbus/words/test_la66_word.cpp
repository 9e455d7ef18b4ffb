// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/la66_word.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel::la66 {
namespace {

// LA-66 manual 3: D31..D24 of OUT with the service bit set.
TEST(La66Word, ServiceWordsAreThoseOfTheManual)
{
    struct Row
    {
        unsigned service;
        std::optional<Word> write;
        std::optional<Word> read;
    };
    const Row rows[] = {
        {countingDirection, 0xC1, 0x81}, {measuringLength, 0xC2, 0x82}, {externalPreset, 0xC4, 0x84},
        {presetAdjustment, 0xC6, {}},    {errorStatus, {}, 0x88},
    };
    for (const Row &row : rows) {
        EXPECT_EQ(canBeWritten(row.service), row.write.has_value()) << row.service;
        EXPECT_EQ(canBeRead(row.service), row.read.has_value()) << row.service;
        if (row.write) {
            EXPECT_EQ((writeWord(row.service, 0) | serviceBit) >> 24, *row.write) << row.service;
        }
        if (row.read) {
            EXPECT_EQ((readWord(row.service) | serviceBit) >> 24, *row.read) << row.service;
        }
    }
}

// LA-66 manual 3.2: 500 mm at 0.01 mm = 50000 = C350h, at 0.1 mm = 5000 = 1388h
TEST(La66Word, TheDataOfTheServiceBitAreThoseBeforeIt)
{
    EXPECT_EQ(writeWord(measuringLength, 50'000), 0x4200'C350u);
    EXPECT_EQ(writeWord(measuringLength, 50'000) | serviceBit, 0xC200'C350u);
    EXPECT_EQ(writeWord(measuringLength, 5'000), 0x4200'1388u);
    EXPECT_EQ(writeWord(presetAdjustment, 0xFF'FFFF), 0x46FF'FFFFu);
}

TEST(La66Word, EncodeAndDecodeAreInverse)
{
    std::mt19937 random(66); // seeded: the same words in each run
    for (int i = 0; i < 100'000; ++i) {
        const unsigned number = random() % 16;
        const Word value = i % 4 == 0 ? (i % 8 == 0 ? 0 : dataMask) : random() & dataMask;
        const Word written = writeWord(number, value);
        ASSERT_EQ(service(written), number);
        ASSERT_EQ(data(written), value);
        ASSERT_TRUE(isWrite(written));
        ASSERT_FALSE(isServiceMode(written));
        ASSERT_EQ(service(readWord(number)), number);
        ASSERT_FALSE(isWrite(readWord(number)));
    }
}

TEST(La66Word, AnAnswerHasServiceAndDirectionOfTheRequest)
{
    EXPECT_TRUE(answers(0xC200'C350, 0xC200'C350));
    EXPECT_TRUE(answers(0xC200'C350, 0x4200'C350)) << "the service bit of OUT may be gone again";
    EXPECT_TRUE(answers(0xE200'0000, 0xC200'0000)) << "refused, but answered";
    EXPECT_TRUE(answers(0x8200'C350, 0x8200'0000));
    EXPECT_FALSE(answers(0x8200'C350, 0xC200'C350));
    EXPECT_FALSE(answers(0xC100'0001, 0xC200'0001));
    EXPECT_FALSE(answers(0x0200'C350, 0x8200'0000));
    EXPECT_FALSE(answers(0x0000'C350, 0x8000'C350));
}

} // namespace
} // namespace codewheel::la66
