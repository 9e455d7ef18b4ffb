// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/rod_scale.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// LA-66 manual 3.2
TEST(RodScale, TheExamplesOfTheManual)
{
    const auto hundredth = rodScale(50'000, 500'000);
    ASSERT_TRUE(hundredth);
    EXPECT_DOUBLE_EQ(hundredth->millimetres(50'000), 500);
    EXPECT_DOUBLE_EQ(hundredth->millimetres(12'345), 123.45);
    const auto tenth = rodScale(5'000, 500'000);
    ASSERT_TRUE(tenth);
    EXPECT_DOUBLE_EQ(tenth->millimetres(1'234), 123.4);
}

TEST(RodScale, TheDecimalsTellOneStepFromTheNext)
{
    EXPECT_EQ(rodScale(50'000, 500'000)->text(12'345), QStringLiteral("123.45 mm"));
    EXPECT_EQ(rodScale(5'000, 500'000)->text(1'234), QStringLiteral("123.4 mm"));
    EXPECT_EQ(rodScale(500, 500'000)->text(123), QStringLiteral("123 mm"));
    EXPECT_EQ(rodScale(100, 500'000)->text(3), QStringLiteral("15 mm"));
    EXPECT_EQ(rodScale(40'000, 500'000)->text(1), QStringLiteral("0.01 mm"));
    EXPECT_EQ(rodScale(16'777'215, 500'000)->text(16'777'215), QStringLiteral("500.000 mm"));
}

TEST(RodScale, WithoutOneOfTheTwoLengthsThereAreNoMillimetres)
{
    EXPECT_EQ(rodScale(std::nullopt, 500'000), std::nullopt);
    EXPECT_EQ(rodScale(50'000, std::nullopt), std::nullopt);
    EXPECT_EQ(rodScale(0, 500'000), std::nullopt);
}

} // namespace
} // namespace codewheel
