// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/decimal_text.h"

#include <QLocale>

#include <gtest/gtest.h>
#include <optional>

namespace codewheel {
namespace {

struct TypedDecimal
{
    const char *text;
    std::optional<double> english;
    std::optional<double> german;
};

const TypedDecimal typedDecimals[] = {
    {"0.01", 0.01, 0.01},
    {"0,01", 0.01, 0.01},
    {"2.5", 2.5, 2.5},
    {"2,5", 2.5, 2.5},
    {"-3,25", -3.25, -3.25},
    {" 7 ", 7, 7},
    {"0,001", 0.001, 0.001},
    {"0.001", 0.001, 0.001},
    {"1000", 1000, 1000},
    {"1 000", 1000, 1000},
    {"1 000,5", 1000.5, 1000.5},
    {"12 345.678", 12'345.678, 12'345.678},
    {"1,000", {}, 1.0},
    {"1.000", 1.0, {}},
    {"12,345", {}, 12.345},
    {"1234,567", 1234.567, 1234.567},
    {"1,000.5", {}, {}},
    {"1.000,5", {}, {}},
    {"1.000.000", {}, {}},
    {"", {}, {}},
    {"abc", {}, {}},
    {"1e999", {}, {}},
    {"nan", {}, {}},
    {"inf", {}, {}},
    {"5 mm", {}, {}},
    {"0x10", {}, {}},
};

TEST(DecimalText, PointAndCommaStandBeforeDecimalsUnlessTheyMayStandBetweenThousands)
{
    for (const TypedDecimal &row : typedDecimals) {
        const auto english = readDecimal(QString::fromLatin1(row.text), QLocale(QLocale::English));
        const auto german = readDecimal(QString::fromLatin1(row.text), QLocale(QLocale::German));
        EXPECT_EQ(english ? std::optional(*english) : std::nullopt, row.english) << row.text;
        EXPECT_EQ(german ? std::optional(*german) : std::nullopt, row.german) << row.text;
    }
}

TEST(DecimalText, ARefusalSaysBothMeanings)
{
    const auto english = readDecimal(QStringLiteral("1,000"), QLocale(QLocale::English));
    ASSERT_FALSE(english);
    EXPECT_TRUE(english.error().contains(QStringLiteral("1000"))) << english.error().toStdString();
    EXPECT_TRUE(english.error().contains(QStringLiteral("1.000"))) << english.error().toStdString();
    const auto word = readDecimal(QStringLiteral("abc"), QLocale(QLocale::English));
    ASSERT_FALSE(word);
    EXPECT_EQ(word.error(), QStringLiteral("\"abc\" is not a number."));
}

struct TypedWhole
{
    const char *text;
    std::optional<std::int64_t> number;
};

// A technician's "1.000" is a thousand or one: it is neither.
const TypedWhole typedWholes[] = {
    {"1000", 1000}, {" 1 000 ", 1000}, {"-12 345", -12'345}, {"0x1F", 31}, {"1Fh", 31},       {"007", 7},
    {"1.000", {}},  {"1,000", {}},     {"1.", {}},           {"1.0", {}},  {"12,5", {}},      {"1'000", {}},
    {"", {}},       {"abc", {}},       {"1e3", {}},          {"5 mm", {}}, {"1.000.000", {}},
};

TEST(DecimalText, AWholeNumberIsWrittenInDigits)
{
    for (const TypedWhole &row : typedWholes) {
        const auto number = readWhole(QString::fromLatin1(row.text));
        EXPECT_EQ(number ? std::optional(*number) : std::nullopt, row.number) << row.text;
    }
    for (const QChar space : {QChar(QChar::Nbsp), QChar(0x202F)})
        EXPECT_EQ(readWhole(QStringLiteral("8") + space + QStringLiteral("192")).value_or(0), 8192);
    EXPECT_EQ(readWhole(QStringLiteral("1.000")).error(),
              QStringLiteral("\"1.000\" is not a whole number. Digits only, for example 1000."));
}

} // namespace
} // namespace codewheel
