// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/exchange_trace.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct TraceCycle
{
    Word out;
    Word in;
    bool isRow;
};

void expectRows(const std::vector<TraceCycle> &cycles)
{
    ExchangeTrace trace(1);
    int number = 0;
    for (const TraceCycle &cycle : cycles)
        EXPECT_EQ(trace.isRow(0, cycle.out, cycle.in), cycle.isRow) << "cycle " << ++number;
}

// FRABA manual 5.4.1: what 40000000 causes shows in the position alone
TEST(ExchangeTraceTest, ThePositionThatAPresetCausesIsARow)
{
    expectRows({{0, 0x3039, true},
                {0x4000'0000, 0x3039, true},
                {0x4000'0000, 0x3039, false},
                {0x4000'0000, 0, true},
                {0x4000'0000, 0, false},
                {0, 0, true}});
}

// Another word follows 60000000 at once.
TEST(ExchangeTraceTest, SoIsThatOfAPresetOfOneCycle)
{
    expectRows({{0, 0x3039, true},
                {0x6000'0000, 0x3039, true},
                {0, 0x3039, true},
                {0, 0x0064, true},
                {0, 0x0065, false}});
}

TEST(ExchangeTraceTest, ATurningShaftGivesNone)
{
    expectRows({{0, 1'000, true},
                {0, 1'050, false},
                {0x4000'0000, 1'100, true},
                {0x4000'0000, 1'150, false},
                {0x4000'0000, 300, true},
                {0x4000'0000, 350, false},
                {0, 400, true},
                {0, 450, false}});
}

} // namespace
} // namespace codewheel
