// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_cam_fields.h"
#include "vocabulary/hex.h"

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

struct FieldRow
{
    CamField field;
    std::int64_t data;
    Word sets;
    Word readsOut;
};

// FRABA manual 5.4.4 and 10.5, literally
TEST(CamFields, HaveTheWordsOfTheManual)
{
    const FieldRow rows[] = {
        {{CamValue::start, 3}, 0x15, 0x4600'0015, 0x2020'0013},
        {{CamValue::stop, 3}, 0x213, 0x6600'0213, 0x2020'0023},
        {{CamValue::activeCams, 0}, 0x08, 0x2040'0008, 0x2020'0000},
        {{CamValue::activeCams, 0}, 0x93, 0x2040'0093, 0x2020'0000},
        {{CamValue::shift, 0}, 25, 0x2010'0019, 0x2020'0040},
        {{CamValue::start, 0}, 0, 0x4000'0000, 0x2020'0010},
        {{CamValue::stop, 7}, 0x1FF'FFFF, 0x6FFF'FFFF, 0x2020'0027},
    };
    for (const FieldRow &row : rows) {
        EXPECT_EQ(settingWord(row.field, row.data), row.sets) << hexWord(row.sets).toStdString();
        EXPECT_EQ(fieldSetBy(row.sets), row.field);
        EXPECT_EQ(dataOf(row.field, row.sets), row.data);
        EXPECT_EQ(readOutWord(row.field), row.readsOut) << hexWord(row.readsOut).toStdString();
        EXPECT_EQ(fieldReadBy(row.readsOut), row.field);
    }
}

TEST(CamFields, WordsOfCamsThereAreNotAndOfAnythingElseSetNothing)
{
    for (const Word out : {0x5000'0000u, 0x7E00'0000u, 0x0200'00FFu, 0x2080'0001u, 0x2021'0013u,
                           0x2040'0000u | 1u << 25, 0x2010'0100u, 0xC600'0015u, 0x8000'0000u, 0x0000'0000u})
        EXPECT_FALSE(fieldSetBy(out)) << hexWord(out).toStdString();
    for (const Word out :
         {0x2020'0018u, 0x2020'0028u, 0x2020'0030u, 0x2020'0001u, 0x2020'0100u, 0x2021'0013u})
        EXPECT_FALSE(fieldReadBy(out)) << hexWord(out).toStdString();
}

TEST(CamFields, WhatHasNoWordComesBackToo)
{
    CamProgram from;
    from.cam[2] = {10, 20, true, 3, false};
    from.cam[7] = {10, 20, false, 4, true};
    CamProgram to;
    for (std::size_t i = 0; i < allCamFieldCount; ++i) {
        EXPECT_EQ(indexOf(camField(i)), i);
        setValue(to, camField(i), valueOf(from, camField(i)));
    }
    EXPECT_EQ(to, from);
}

TEST(CamFields, EveryFieldOfEveryProgramComesBackFromItsWord)
{
    std::mt19937 random(545);
    const auto below = [&](std::uint32_t limit) {
        switch (random() % 4) {
        case 0:
            return std::int64_t{0};
        case 1:
            return std::int64_t{limit} - 1;
        default:
            return static_cast<std::int64_t>(random() % limit);
        }
    };
    for (int round = 0; round < 10'000; ++round) {
        CamProgram sent{.number = 1, .cam = {}, .shift = static_cast<unsigned>(below(26))};
        for (Cam &cam : sent.cam)
            cam = {below(1U << 25), below(1U << 25), below(2) == 1};
        CamProgram received{.number = 1, .cam = {}, .shift = 7};
        for (std::size_t i = 0; i < camFieldCount; ++i) {
            const Word out = settingWord(camField(i), valueOf(sent, camField(i)));
            const auto field = fieldSetBy(out);
            ASSERT_EQ(field, camField(i)) << hexWord(out).toStdString();
            EXPECT_EQ(indexOf(*field), i);
            setValue(received, *field, dataOf(*field, out));
        }
        ASSERT_EQ(received, sent);
        ASSERT_TRUE(differences(received, sent).none());
    }
}

} // namespace
} // namespace codewheel
