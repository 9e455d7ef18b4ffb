// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/csv_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(ShownText, WhatSteersATerminalIsAnEscape)
{
    const struct
    {
        QString text;
        const char *shown;
    } rows[] = {
        {QStringLiteral("Crane 1, Förderband · 位置"), "Crane 1, Förderband · 位置"},
        {QStringLiteral("\u001B[2J"), "\\u001B[2J"},
        {QStringLiteral("a\rb\bc\u007F"), "a\\u000Db\\u0008c\\u007F"},
        {QStringLiteral("\u009B31m"), "\\u009B31m"},
        {QStringLiteral("\u202Edna\u202C \u2066x\u2069"), "\\u202Edna\\u202C \\u2066x\\u2069"},
        {QStringLiteral("\u200E\u200F\u061C\uFEFF"), "\\u200E\\u200F\\u061C\\uFEFF"},
        {QStringLiteral("one\u2028two\u2029"), "one\\u2028two\\u2029"},
        {QStringLiteral("\U0001F3D7 site"), "\U0001F3D7 site"}, // a surrogate pair
        {QString(QChar(0xD83C)), "\\uD83C"},
        {QString(QChar(u'\0')) + u'x', "\\u0000x"},
    };
    for (const auto &[text, shown] : rows) {
        EXPECT_EQ(shownText(text).toStdString(), shown);
        EXPECT_EQ(shownInLine(text).toStdString(), shown);
    }
}

TEST(ShownText, LineBreaksStayInATextButNotInALine)
{
    EXPECT_EQ(shownText(QStringLiteral("a\tb\nc")), QStringLiteral("a\tb\nc"));
    EXPECT_EQ(shownInLine(QStringLiteral("a\tb\nc")).toStdString(), "a\\u0009b\\u000Ac");
}

TEST(ShownText, TheSentenceMayBreakItsLineWhatIsPutInMayNot)
{
    EXPECT_EQ(sentence(QStringLiteral("%1\nis gone"), {QStringLiteral("x\n\u001Bc")}).toStdString(),
              "x\\u000A\\u001Bc\nis gone");
}

TEST(CsvText, WhatASpreadsheetWouldCalculateGetsAnApostrophe)
{
    const std::pair<const char *, const char *> rows[] = {
        {"", R"("")"},
        {"power off", R"("power off")"},
        {R"(a "b", c)", R"("a ""b"", c")"},
        {"=1+1", R"("'=1+1")"},
        {"+1", R"("'+1")"},
        {"-1", R"("'-1")"},
        {"@SUM A1", R"("'@SUM A1")"},
        {"\t=1", "\"'\t=1\""},
        {"1-2=3", R"("1-2=3")"},
    };
    for (const auto &[text, cell] : rows)
        EXPECT_EQ(csvText(QString::fromLatin1(text)).toStdString(), cell);
}

} // namespace
} // namespace codewheel
