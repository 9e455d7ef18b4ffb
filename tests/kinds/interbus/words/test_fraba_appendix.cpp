// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/words/explain_table.h"
#include "tests/support/fraba_appendix.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

namespace codewheel::k3 {
namespace {

bool isPrinted(Word word, std::string_view digits)
{
    char text[9];
    std::snprintf(text, sizeof text, "%08X", word);
    return std::ranges::equal(digits, std::string_view(text),
                              [](char printed, char digit) { return printed == 'x' || printed == digit; });
}

Explanation explained(const AppendixRow &row, WordDirection direction, std::optional<Mode> mode)
{
    const bool out = direction == WordDirection::out;
    return explain(out ? row.out : row.in,
                   {direction, Dialect::fraba, mode, PositionCoding::binary, out ? row.in : row.out});
}

TEST(FrabaAppendix, EveryRowIsThere)
{
    std::map<std::string, std::set<std::string>> names;
    for (const AppendixRow &row : frabaAppendix())
        names[row.section].insert(row.name);
    EXPECT_EQ(names["10.1"].size(), 9u);
    EXPECT_EQ(names["10.2"].size(), 17u);
    EXPECT_EQ(names["10.3"].size(), 6u);
    EXPECT_EQ(names["10.4"].size(), 4u);
    EXPECT_EQ(names["10.5"].size(), 12u);
    EXPECT_EQ(names["10.6"].size(), 6u);
}

TEST(FrabaAppendix, TheWordsAreThoseOfItsColumn)
{
    for (const AppendixRow &row : frabaAppendix())
        EXPECT_TRUE(isPrinted(row.column == WordDirection::out ? row.out : row.in, row.printed))
            << row.section << ' ' << row.name;
}

TEST(FrabaAppendix, EveryRowIsExplainedOutAndIn)
{
    for (const AppendixRow &row : frabaAppendix()) {
        EXPECT_EQ(explained(row, WordDirection::out, row.mode), row.outMeans)
            << row.section << ' ' << row.name;
        EXPECT_EQ(explained(row, WordDirection::in, row.mode), row.inMeans) << row.section << ' ' << row.name;
    }
}

TEST(FrabaAppendix, WhereTheModeIsNotKnownTheMeaningIsAmongThePossibleOnes)
{
    for (const AppendixRow &row : frabaAppendix()) {
        const Explanation out = explained(row, WordDirection::out, {});
        const Explanation in = explained(row, WordDirection::in, {});
        // A parameter that cam mode refuses is a parameter in all other modes.
        const bool refused = row.outMeans.id == MeaningId::parameterRequestInCamMode;
        EXPECT_EQ(std::ranges::find(out, row.outMeans) == out.end(), refused)
            << row.section << ' ' << row.name;
        EXPECT_NE(std::ranges::find(in, row.inMeans), in.end()) << row.section << ' ' << row.name;
    }
}

} // namespace
} // namespace codewheel::k3
