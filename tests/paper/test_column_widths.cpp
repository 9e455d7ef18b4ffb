// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/column_widths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;

TEST(ColumnWidths, WhoWantsLittleGetsIt)
{
    EXPECT_THAT(columnWidths({10, 500, 20}, 100), ElementsAre(10, 70, 20));
}

TEST(ColumnWidths, WhoWantsMuchShares)
{
    EXPECT_THAT(columnWidths({500, 10, 900}, 110), ElementsAre(50, 10, 50));
}

TEST(ColumnWidths, WhatIsLeftIsSharedInProportion)
{
    EXPECT_THAT(columnWidths({10, 30}, 80), ElementsAre(20, 60));
}

} // namespace
} // namespace codewheel
