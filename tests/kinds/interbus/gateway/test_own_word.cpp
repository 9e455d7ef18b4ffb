// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/own_word.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Word firstOwn = 0x0200'00FF;
constexpr Word secondOwn = 0x8000'0000;
constexpr Word thirdOwn = 0x0400'0001;

TEST(OwnWord, WhatWasFoundIsOursAndNothingElse)
{
    OwnWord own;
    EXPECT_TRUE(own.takes(firstOwn, 0ms)) << "nothing is known yet";
    own.found(firstOwn);
    EXPECT_TRUE(own.takes(firstOwn, 0ms));
    EXPECT_FALSE(own.takes(secondOwn, 0ms));
    EXPECT_EQ(own.word(), firstOwn);
}

TEST(OwnWord, WhatWasReplacedMayStillShowForAWhile)
{
    OwnWord own;
    own.found(0);
    own.write(firstOwn, 10ms);
    own.write(secondOwn, 20ms);
    EXPECT_TRUE(own.takes(0, 30ms));
    EXPECT_TRUE(own.takes(firstOwn, 30ms));
    EXPECT_FALSE(own.takes(thirdOwn, 30ms));
    EXPECT_FALSE(own.takes(firstOwn, 20ms + OwnWord::gatewayLag));
    EXPECT_TRUE(own.takes(secondOwn, 1h));
}

TEST(OwnWord, WhatWasReplacedByWhatHasArrivedDoesNotComeBack)
{
    OwnWord own;
    own.found(0);
    own.write(firstOwn, 10ms);
    own.write(secondOwn, 20ms);
    EXPECT_TRUE(own.takes(firstOwn, 30ms));
    EXPECT_FALSE(own.takes(0, 30ms));
    EXPECT_TRUE(own.takes(secondOwn, 40ms));
    EXPECT_FALSE(own.takes(firstOwn, 40ms)) << "somebody else has written it again";
}

TEST(OwnWord, WritingTheSameAgainChangesNothing)
{
    OwnWord own;
    own.found(0);
    own.write(firstOwn, 10ms);
    own.write(firstOwn, 500ms);
    EXPECT_TRUE(own.takes(0, 1000ms));
    EXPECT_FALSE(own.takes(0, 10ms + OwnWord::gatewayLag));
}

TEST(OwnWord, AWriteWithoutAnAnswerMayBeCarriedOutLater)
{
    OwnWord own;
    own.found(0);
    own.write(firstOwn, 0ms);
    own.wasNotAnswered();
    EXPECT_TRUE(own.takes(0, 20s)) << "however long that takes";
    own.wasAnswered(20s);
    EXPECT_TRUE(own.takes(0, 20s + 500ms));
    EXPECT_FALSE(own.takes(0, 20s + OwnWord::gatewayLag));
}

TEST(OwnWord, WhatWasNotSentLeavesTheOneBeforeThere)
{
    OwnWord own;
    own.found(firstOwn);
    own.write(secondOwn, 0ms);
    own.wasNotSent();
    own.isThere();
    EXPECT_TRUE(own.isShownBy(firstOwn));
    EXPECT_TRUE(own.takes(firstOwn, 20s));
    own.wasAnswered(20s); // it was sent again
    EXPECT_FALSE(own.isShownBy(firstOwn));
    own.isThere();
    EXPECT_FALSE(own.takes(firstOwn, 20s));
}

TEST(OwnWord, WhatMayHaveBeenSentIsNotUnsentByATryThatWasNot)
{
    OwnWord own;
    own.found(firstOwn);
    own.write(secondOwn, 0ms);
    own.wasNotAnswered();
    own.wasNotSent();
    EXPECT_FALSE(own.isShownBy(firstOwn));
    own.isThere();
    EXPECT_FALSE(own.takes(firstOwn, 0ms));
}

// The same word is sent in each exchange.
TEST(OwnWord, WhatWasAnsweredOnceHasArrived)
{
    OwnWord own;
    own.found(firstOwn);
    own.write(secondOwn, 0ms);
    own.wasAnswered(0ms);
    own.write(secondOwn, 2s);
    own.wasNotAnswered();
    EXPECT_FALSE(own.takes(firstOwn, 2s));
    EXPECT_TRUE(own.takes(secondOwn, 2s));
}

TEST(OwnWord, AfterAnInterruptionNothingIsKnown)
{
    OwnWord own;
    own.found(firstOwn);
    own.forget();
    EXPECT_FALSE(own.isKnown());
}

} // namespace
} // namespace codewheel
