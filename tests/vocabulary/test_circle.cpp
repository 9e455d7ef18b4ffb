// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/circle.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(Circle, GoesOnAtTheOtherEnd)
{
    EXPECT_EQ(modulo(100, 100), 0);
    EXPECT_EQ(modulo(-1, 100), 99);
}

TEST(Circle, TheShorterWayMayGoOverTheEnd)
{
    EXPECT_EQ(shorterWay(10, 30, 100), 20);
    EXPECT_EQ(shorterWay(95, 5, 100), 10);
    EXPECT_EQ(shorterWay(5, 95, 100), -10);
    EXPECT_EQ(shorterWay(0, 50, 100), 50);
    EXPECT_EQ(shorterWay(0, 3, 5), -2);
}

TEST(Circle, TheUpperHalfOfSignedPositionsIsBelowZero)
{
    EXPECT_EQ(signedPosition(49, 100), 49);
    EXPECT_EQ(signedPosition(50, 100), -50);
    EXPECT_EQ(signedPosition(2, 5), 2);
    EXPECT_EQ(signedPosition(3, 5), -2);
}

} // namespace
} // namespace codewheel
