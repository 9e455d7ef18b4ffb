// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/turn_check.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(TurnCheckTest, CountsMovesAndSeesThroughTheWrap)
{
    TurnCheck check;
    check.begin(1000);
    check.take(990);
    EXPECT_EQ(check.verdict(), TurnCheck::Verdict::doesNotMove);
    check.take(5);
    EXPECT_EQ(check.verdict(), TurnCheck::Verdict::countsUp);
    EXPECT_EQ(check.moved(), 15);
    check.take(995);
    EXPECT_EQ(check.verdict(), TurnCheck::Verdict::goesBothWays);
    check.take(980);
    EXPECT_EQ(check.verdict(), TurnCheck::Verdict::countsDown);
}

} // namespace
} // namespace codewheel
