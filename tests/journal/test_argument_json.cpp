// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/argument_json.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <gtest/gtest.h>
#include <limits>

namespace codewheel {
namespace {

std::vector<RefusalArgument> parsed(const char *json)
{
    return argumentsFromJson(QJsonDocument::fromJson(json).array());
}

TEST(ArgumentJson, IsAsDocumented)
{
    EXPECT_EQ(jsonLine(argumentsToJson({std::int64_t{255}, 0.5, Word{0x020000FF}, Parameter::zeroOffset,
                                        QStringLiteral("1/4 \"turn\"")})),
              QStringLiteral("[255,{\"double\":0.5},{\"word\":\"020000FF\"},{\"parameter\":\"zero-offset\"},"
                             "\"1/4 \\\"turn\\\"\"]"));
}

TEST(ArgumentJson, GivesBackWhatWasKept)
{
    const std::vector<RefusalArgument> all{std::numeric_limits<std::int64_t>::max(),
                                           std::numeric_limits<std::int64_t>::min(),
                                           std::int64_t{0},
                                           2.0,
                                           -1e300,
                                           Word{0xFFFFFFFF},
                                           Parameter::of(u"opc-register-15"),
                                           QString(),
                                           QStringLiteral("¼ %1")};
    EXPECT_EQ(argumentsFromJson(argumentsToJson(all)), all);
}

TEST(ArgumentJson, ShowsAsTextWhatItDoesNotUnderstand)
{
    const std::vector<RefusalArgument> expected{QStringLiteral("{\"speed\":[1,2]}"),
                                                QStringLiteral("{\"parameter\":\"colour\"}"),
                                                QStringLiteral("{\"word\":\"nothing\"}"),
                                                QStringLiteral("null"),
                                                QStringLiteral("[true]"),
                                                1.5};
    EXPECT_EQ(
        parsed(R"([{"speed": [1, 2]}, {"parameter": "colour"}, {"word": "nothing"}, null, [true], 1.5])"),
        expected);
    EXPECT_TRUE(parsed("{\"no\": \"array\"}").empty());
    EXPECT_TRUE(parsed("[1, 2").empty());
}

} // namespace
} // namespace codewheel
