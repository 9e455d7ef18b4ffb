// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/k3_explain.h"

#include <gtest/gtest.h>

namespace codewheel::k3 {
namespace {

struct SentWord
{
    Word in;
    bool fraba;
    bool baumer;
};

class K3Plausible : public testing::TestWithParam<SentWord>
{};

TEST_P(K3Plausible, IsJudgedByMake)
{
    const SentWord &word = GetParam();
    EXPECT_EQ(canSend(word.in, Dialect::fraba), word.fraba);
    EXPECT_EQ(canSend(word.in, Dialect::baumer), word.baumer);
    EXPECT_EQ(canSend(word.in, Dialect::generic), word.fraba || word.baumer);
}

INSTANTIATE_TEST_SUITE_P(Words, K3Plausible,
                         testing::Values(SentWord{0x0000'0000, true, true},   // positions
                                         SentWord{0x01FF'FFFF, true, true},   //
                                         SentWord{0x0200'0000, false, false}, // with a number
                                         SentWord{0x2000'0000, false, false}, // with D29
                                         SentWord{0x4000'0000, false, false}, // no state
                                         SentWord{0xC000'0000, true, true},   // processing
                                         SentWord{0xC200'00FF, true, true},   // confirmations
                                         SentWord{0xDE00'0001, true, true},   // 15
                                         SentWord{0xD000'0001, false, true},  // 8
                                         SentWord{0xEE00'0001, true, false},  // end of cam 7
                                         SentWord{0xF000'0001, false, false}, // there is no cam 8
                                         SentWord{0x8000'0000, true, true},   // errors
                                         SentWord{0x8600'0000, true, true},   //
                                         SentWord{0x8600'0001, false, false}, //
                                         SentWord{0x9C00'0000, false, true},  //
                                         SentWord{0x9800'0004, true, false},  //
                                         SentWord{0x9800'0100, false, false}, //
                                         SentWord{0xA000'1234, true, false},  // read out
                                         SentWord{0xA400'000B, true, false},  //
                                         SentWord{0xA400'0100, false, false}, //
                                         SentWord{0xA200'0000, false, false}));

} // namespace
} // namespace codewheel::k3
