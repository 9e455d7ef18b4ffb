// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/arguments.h"

#include <array>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr std::array options{Option{"--all", nullptr, ""}, Option{"--hold", "CYCLES", ""}};

Checked<Arguments> parse(const char *line)
{
    return parseArguments(QString::fromLatin1(line).split(u' ', Qt::SkipEmptyParts), options,
                          QStringLiteral("words"));
}

QString errorOf(const char *line)
{
    const auto parsed = parse(line);
    return parsed ? QString() : parsed.error().key;
}

TEST(CliArguments, OptionsMayStandAnywhere)
{
    const auto parsed = parse("1.0 --all steps=255 --hold 7 preset=0");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->rest, QStringLiteral("1.0 steps=255 preset=0").split(u' '));
    EXPECT_TRUE(parsed->has("--all"));
    EXPECT_EQ(parsed->value("--hold"), QStringLiteral("7"));
}

TEST(CliArguments, AValueMayBeAttached)
{
    const auto parsed = parse("--hold=a=b");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->value("--hold"), QStringLiteral("a=b"));
    EXPECT_FALSE(parsed->value("--all"));
}

TEST(CliArguments, ANumberWithAMinusAndWhatFollowsTwoMinusesAreNoOptions)
{
    const auto parsed = parse("-5 - -- --all");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->rest, QStringLiteral("-5 - --all").split(u' '));
    EXPECT_FALSE(parsed->has("--all"));
}

TEST(CliArguments, WhatIsWrongIsNamed)
{
    EXPECT_EQ(errorOf("--any"), QStringLiteral("unknownOption"));
    EXPECT_EQ(errorOf("-x"), QStringLiteral("unknownOption"));
    EXPECT_EQ(errorOf("--all --all"), QStringLiteral("optionGivenTwice"));
    EXPECT_EQ(errorOf("--all=yes"), QStringLiteral("optionWithoutValue"));
    EXPECT_EQ(errorOf("--hold"), QStringLiteral("optionNeedsValue"));
    EXPECT_EQ(parse("--any").error().text,
              QStringLiteral("There is no option \"--any\" of words. Its options are: --all, --hold."));
}

TEST(CliArguments, NumbersKeepToTheirRange)
{
    EXPECT_EQ(parse("").value().number("--hold", 3, 1, 10), 3);
    EXPECT_EQ(parse("--hold 10").value().number("--hold", 3, 1, 10), 10);
    EXPECT_EQ(parse("--hold 0Ah").value().number("--hold", 3, 1, 10), 10);
    for (const char *line : {"--hold 0", "--hold 11", "--hold -1", "--hold 1.5", "--hold x"}) {
        const auto number = parse(line).value().number("--hold", 3, 1, 10);
        ASSERT_FALSE(number) << line;
        EXPECT_EQ(number.error().key, QStringLiteral("optionOutOfRange"));
    }
}

} // namespace
} // namespace codewheel
