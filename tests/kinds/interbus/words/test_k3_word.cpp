// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_word.h"

#include <gtest/gtest.h>

namespace codewheel::k3 {
namespace {

// FRABA manual 5.3 and 10.1, Baumer manual example 2
TEST(K3Word, ParameterWordsAreThoseOfTheManuals)
{
    EXPECT_EQ(parameterWord(1, 255), 0x0200'00FFu);
    EXPECT_EQ(parameterWord(2, 1), 0x0400'0001u);
    EXPECT_EQ(parameterWord(3, 3), 0x0600'0003u);
    EXPECT_EQ(parameterWord(4, 0), 0x0800'0000u);
    EXPECT_EQ(parameterWord(2, 20'000), 0x0400'4E20u);
    EXPECT_EQ(parameterWord(15, 4096), 0x1E00'1000u);
    EXPECT_EQ(parameterWord(1, dataMask), 0x03FF'FFFFu);
}

} // namespace
} // namespace codewheel::k3
