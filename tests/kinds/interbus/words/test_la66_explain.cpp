// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/la66_explain.h"
#include "tests/kinds/interbus/words/explain_table.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel::la66 {
namespace {

using enum MeaningId;
constexpr auto out = WordDirection::out;
constexpr auto in = WordDirection::in;

struct Row
{
    Word word;
    Meaning meaning;
};

TEST(La66Explain, OutWordsOfEachService)
{
    const Row rows[] = {
        {0x0000'0000, {normalRunning}},
        {0x0000'3039, {normalRunningData, {12'345}}},
        {0xC100'0000, {serviceWrite, {1, 0, 1}}},
        {0xC100'0001, {serviceWrite, {1, 1, 1}}},
        {0xC100'0002, {serviceWriteInvalid, {1, 2, 1}}},
        {0x8100'0000, {serviceRead, {1, 1}}},
        {0x4200'C350, {serviceWrite, {2, 50'000, 0}}},
        {0xC200'C350, {serviceWrite, {2, 50'000, 1}}},
        {0xC200'0000, {serviceWriteInvalid, {2, 0, 1}}},
        {0xC2FF'FFFF, {serviceWrite, {2, 16'777'215, 1}}},
        {0x0200'0000, {serviceRead, {2, 0}}},
        {0x82FF'FFFF, {serviceRead, {2, 1}}}, // the data of a read mean nothing
        {0xC400'1388, {serviceWrite, {4, 5'000, 1}}},
        {0x8400'0000, {serviceRead, {4, 1}}},
        {0xC600'03E8, {serviceWrite, {6, 1'000, 1}}},
        {0x8800'0000, {serviceRead, {8, 1}}},
        // write only, read only, no service, error and reserved bit
        {0x8600'0000, {undefinedOut, {0x8600'0000}}},
        {0xC800'0000, {undefinedOut, {0xC800'0000}}},
        {0x8000'0000, {undefinedOut, {0x8000'0000}}},
        {0xC300'0001, {undefinedOut, {0xC300'0001}}},
        {0xE200'C350, {undefinedOut, {0xE200'C350}}},
        {0xD200'C350, {undefinedOut, {0xD200'C350}}},
    };
    for (const Row &row : rows)
        EXPECT_EQ(explain(row.word, out, {}), row.meaning) << std::hex << row.word;
}

TEST(La66Explain, InWordsOfEachService)
{
    const Row rows[] = {
        {0x0000'0000, {position, {0}}},
        {0x00FF'FFFF, {position, {16'777'215}}},
        {0x2000'3039, {positionWithError, {12'345}}},
        {0x0100'0000, {undefinedIn, {0x0100'0000}}},
        {0x4000'0000, {undefinedIn, {0x4000'0000}}},
        {0x1000'0001, {undefinedIn, {0x1000'0001}}},
        {0xC200'C350, {serviceWritten, {2, 50'000}}},
        {0xC600'03E8, {serviceWritten, {6, 1'000}}},
        {0x8100'0001, {serviceValue, {1, 1}}},
        {0x8200'1388, {serviceValue, {2, 5'000}}},
        {0x8800'0020, {serviceValue, {8, 32}}},
        {0xE200'0000, {serviceRefused, {0xC200'0000}}},
        {0xA600'0000, {serviceRefused, {0x8600'0000}}},
        {0x8000'0000, {undefinedIn, {0x8000'0000}}},
        {0x9200'0001, {undefinedIn, {0x9200'0001}}},
        {0xC800'0000, {undefinedIn, {0xC800'0000}}},
    };
    for (const Row &row : rows)
        EXPECT_EQ(explain(row.word, in, {}), row.meaning) << std::hex << row.word;
}

TEST(La66Explain, AnAnswerToAnEarlierServiceIsAnOldOne)
{
    EXPECT_EQ(explain(0xC200'C350, in, 0xC200'C350), (Meaning{serviceWritten, {2, 50'000}}));
    EXPECT_EQ(explain(0xC200'C350, in, 0x4200'C350), (Meaning{serviceWritten, {2, 50'000}}));
    EXPECT_EQ(explain(0xC200'C350, in, 0x8200'0000), (Meaning{oldServiceAnswer, {2, 50'000, 2}}));
    EXPECT_EQ(explain(0x8100'0001, in, 0x8800'0000), (Meaning{oldServiceAnswer, {1, 1, 8}}));
}

TEST(La66Explain, EveryWordHasOneMeaningOfItsDirection)
{
    std::mt19937 random(33); // seeded: the same words in each run
    const auto check = [&random](Word word) {
        const std::optional<Word> beside =
            random() % 3 == 0 ? std::nullopt : std::optional(static_cast<Word>(random()));
        for (const WordDirection direction : {in, out}) {
            const Explanation explanation = explain(word, direction, beside);
            ASSERT_TRUE(explanation.isUnique()) << std::hex << word;
            ASSERT_EQ(explanation.first().id <= undefinedOut, direction == out) << std::hex << word;
        }
    };
    for (Word top = 0; top < 0x100; ++top)
        for (const Word low : {0x00'0000u, 0x00'0001u, 0x00'0020u, 0x00'C350u, 0xFF'FFFFu})
            check(top << 24 | low);
    for (int i = 0; i < 200'000; ++i)
        check(static_cast<Word>(random()));
}

} // namespace
} // namespace codewheel::la66
