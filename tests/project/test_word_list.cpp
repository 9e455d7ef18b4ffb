// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/word_list.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Words = std::vector<Word>;

TEST(WordList, TakesAPastedColumn)
{
    for (const char *text :
         {"020000FF\n80000000\n00000000", "020000FF\r\n80000000\r\n00000000\r\n",
          "0x20000ff\n\n80000000h\n0\n", "\"020000FF\"\tsteps = 255\n80000000\trun\n\t0000 0000\tnormal\n",
          "020000FF\r80000000\r00000000"}) {
        const auto words = parseColumn(QString::fromLatin1(text));
        ASSERT_TRUE(words) << text;
        EXPECT_EQ(*words, (Words{0x020000FF, 0x80000000, 0})) << text;
    }
}

TEST(WordList, RefusesAColumnWithJunkAsAWholeAndNamesTheLine)
{
    const auto words = parseColumn(QStringLiteral("020000FF\n\nsteps\t80000000\n"));
    ASSERT_FALSE(words);
    EXPECT_TRUE(words.error().startsWith(
        QLatin1String("Nothing was pasted: line 3, \"steps\", is not a hexadecimal word.")))
        << words.error().toStdString();
}

TEST(WordList, AnEmptyPasteAndOneTooLongAreRefused)
{
    EXPECT_TRUE(parseColumn(QStringLiteral(" \n\t\n")).error().startsWith(QLatin1String("There is no word")));
    const QString tooLong = QStringLiteral("0\n").repeated(1001);
    EXPECT_TRUE(parseColumn(tooLong).error().contains(QLatin1String("at most 1000 words")));
}

TEST(WordList, WhatIsSavedIsReadBack)
{
    const WordList list{.words = {0x020000FF, 0x80000000, 0}, .holdCycles = 7};
    const auto read = sequenceFromJson(sequenceToJson(list));
    ASSERT_TRUE(read) << read.error().toStdString();
    EXPECT_EQ(*read, list);
}

TEST(WordList, HoldCyclesMayBeLeftOut)
{
    const auto read =
        sequenceFromJson(R"({"format": "codewheel-sequence", "version": 1, "words": ["80000000"]})");
    ASSERT_TRUE(read) << read.error().toStdString();
    EXPECT_EQ(*read, (WordList{.words = {0x80000000}, .holdCycles = 3}));
}

TEST(WordList, MoreWordsThanASequenceMayHaveAreRefused)
{
    WordList list;
    list.words.resize(WordList::mostWords);
    EXPECT_EQ(sequenceFromJson(sequenceToJson(list)), list);
    list.words.push_back(0);
    const auto read = sequenceFromJson(sequenceToJson(list));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().toStdString(),
              "Line 5, words: The list has 1001 entries; at most 1000 are allowed.");
}

struct BadFile
{
    const char *json;
    const char *begin;
};

TEST(WordList, ABadFileIsRefusedWithItsLine)
{
    const BadFile rows[] = {
        {"", "Line 1: The file is empty."},
        {"[]", "Line 1: This is not a sequence of words"},
        {"{\n\"format\": \"codewheel-plan\"}", "Line 1: This is not a sequence of words"},
        {"{\"format\": \"codewheel-sequence\",\n\"version\": 2, \"words\": []}",
         "Line 2, version: Only version 1"},
        {"{\"format\": \"codewheel-sequence\",\n\"version\": 1,\n\"words\": [\"0\",\n\"020000FG\"]}",
         "Line 4, words[1]: A word is a text"},
        {"{\"format\": \"codewheel-sequence\",\n\"version\": 1,\n\"words\": [5]}",
         "Line 3, words[0]: A word is a text"},
        {"{\"format\": \"codewheel-sequence\", \"version\": 1,\n\"holdCycles\": 0, \"words\": []}",
         "Line 2, holdCycles: 0 is not between 1 and 10000."},
        {"{\"format\": \"codewheel-sequence\", \"version\": 1, \"words\": \"0\"}",
         "Line 1, words: A list [ ] is expected"},
        {"{\"format\": \"codewheel-sequence\", \"version\": 1}", "Line 1, words: This key is missing."},
        {"{\"format\": \"codewheel-sequence\", \"version\": 1, \"words\": [],\n\"speed\": 1}",
         "Line 2, speed: This key is not known."},
        {"{\"format\": \"codewheel-sequence\",\n\"version\": 1,\n\"words\": [\"0\"\n\"1\"]}",
         "Line 4: This is not valid JSON"},
        {"{\"a\":[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]}", "Line 1: The file is nested too deeply."},
    };
    for (const BadFile &row : rows) {
        const auto read = sequenceFromJson(row.json);
        ASSERT_FALSE(read) << row.json;
        EXPECT_TRUE(read.error().startsWith(QLatin1String(row.begin))) << row.json << "\n"
                                                                       << read.error().toStdString();
    }
}

} // namespace
} // namespace codewheel
