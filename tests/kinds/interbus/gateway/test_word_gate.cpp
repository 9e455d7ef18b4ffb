// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/word_gate.h"
#include "kinds/interbus/words/profiles.h"

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

// What is believed after each read; 0 before the first.
std::vector<Word> believed(WordGate gate, const std::vector<Word> &reads)
{
    std::vector<Word> words;
    Instant at{};
    for (const Word read : reads) {
        gate.take(read, at += std::chrono::milliseconds(1));
        words.push_back(gate.word());
    }
    return words;
}

const WordGate k3(profile::k3, 2, {});

TEST(WordGate, AHandshakeWordCountsAfterTwoEqualReads)
{
    EXPECT_EQ(believed(k3, {0xC200'00FF, 0xC200'00FF, 0xC400'00FF, 0xC400'1000, 0xC400'1000}),
              (std::vector<Word>{0, 0xC200'00FF, 0xC200'00FF, 0xC200'00FF, 0xC400'1000}));
}

TEST(WordGate, APositionThatMovesIsBelievedOneReadLater)
{
    EXPECT_EQ(believed(k3, {100, 110, 120, 130}), (std::vector<Word>{0, 0, 110, 120}));
}

// A gateway that is read more often than it copies.
TEST(WordGate, APositionThatIsReadTwiceOnItsWayIsBelieved)
{
    const WordGate gate(profile::k3, 2, std::chrono::milliseconds(3));
    EXPECT_EQ(believed(gate, {100, 110, 110, 120, 120, 130}), (std::vector<Word>{0, 0, 0, 110, 110, 120}));
    EXPECT_EQ(believed(gate, {100, 110, 110, 100}), (std::vector<Word>{0, 0, 0, 0})) << "it came back";
}

// Until then no other read has to be asked for at once.
TEST(WordGate, APositionNearTheLastOneBelievedWaitsForTheNextRead)
{
    WordGate gate(profile::k3, 2, std::chrono::milliseconds(3));
    Instant at{};
    for (const Word read : {100U, 110U, 120U})
        gate.take(read, at += std::chrono::milliseconds(1));
    EXPECT_FALSE(gate.take(120, at + std::chrono::milliseconds(1)));
    EXPECT_TRUE(gate.canWait());
    EXPECT_FALSE(gate.take(0xC200'00FF, at + std::chrono::milliseconds(2)));
    EXPECT_FALSE(gate.canWait()) << "a handshake goes on";
    EXPECT_FALSE(gate.take(125, at + std::chrono::milliseconds(3)));
    EXPECT_TRUE(gate.canWait());
    EXPECT_FALSE(gate.take(90'000, at + std::chrono::milliseconds(4)));
    EXPECT_FALSE(gate.canWait()) << "perhaps torn";
    EXPECT_FALSE(gate.take(90'001, at + std::chrono::milliseconds(40)));
    EXPECT_FALSE(gate.canWait()) << "too long";
}

TEST(WordGate, AFastShaftIsBelievedAcrossTheCarry)
{
    EXPECT_EQ(believed(k3, {0xB000, 0x1'2000, 0x1'8FFF, 0x2'0000}),
              (std::vector<Word>{0, 0, 0x1'2000, 0x1'8FFF}));
    EXPECT_EQ(believed(k3, {0x2'0000, 0x1'9000, 0x1'2001}), (std::vector<Word>{0, 0, 0x1'9000}));
}

// Neither torn nor late words are on the way from one neighbour to the other.
TEST(WordGate, AWordThatIsNotOnTheWayIsNotBelieved)
{
    EXPECT_EQ(believed(k3, {100, 90, 110}), (std::vector<Word>{0, 0, 0}));
    EXPECT_EQ(believed(k3, {100, 120, 110}), (std::vector<Word>{0, 0, 0}));
    EXPECT_EQ(believed(k3, {100, 100 + WordGate::nearBy, 101 + WordGate::nearBy}),
              (std::vector<Word>{0, 0, 0}));
}

// Torn, and its answer doubled.
TEST(WordGate, TwoEqualReadsAreNotOnTheWayToAThird)
{
    EXPECT_EQ(believed(k3, {0xF2'9E1C, 0xF4'9E1C, 0xF4'9E1C, 0xF4'75C8}), (std::vector<Word>{0, 0, 0, 0}));
}

TEST(WordGate, TheMiddleOfThreeReadsIsOnlyBelievedIfItIsNew)
{
    WordGate gate = k3;
    gate.take(100, {});
    gate.take(110, std::chrono::milliseconds(10));
    EXPECT_FALSE(gate.take(120, WordGate::longestMovement + std::chrono::milliseconds(1)));
    EXPECT_TRUE(gate.take(130, WordGate::longestMovement + std::chrono::milliseconds(2)));
    EXPECT_EQ(gate.word(), 120u);
    EXPECT_EQ(gate.readAt(), WordGate::longestMovement + std::chrono::milliseconds(1));
}

TEST(WordGate, APositionTornAtItsCarryIsNotBelieved)
{
    // high register first: 0000FFF0 -> 00010010 read as 00000010
    EXPECT_EQ(believed(k3, {0xFFE0, 0xFFE8, 0xFFF0, 0x0010, 0x1'0018, 0x1'0020, 0x1'0028}),
              (std::vector<Word>{0, 0, 0xFFE8, 0xFFE8, 0xFFE8, 0xFFE8, 0x1'0020}));
    // low register first: read as 0001FFF8
    EXPECT_EQ(believed(k3, {0xFFE0, 0xFFE8, 0xFFF0, 0x1'FFF8, 0x1'0010, 0x1'0018, 0x1'0020}),
              (std::vector<Word>{0, 0, 0xFFE8, 0xFFE8, 0xFFE8, 0xFFE8, 0x1'0018}));
}

// A shaft that trembles between 0000FFFF and 00010000.
TEST(WordGate, APositionFarFromTheOneBeforeIsBelievedAfterThreeEqualReads)
{
    EXPECT_EQ(believed(k3, {0xFFFF, 0xFFFF, 0xFFFF, 0, 0, 0xFFFF, 0xFFFF}),
              (std::vector<Word>{0, 0, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}));
    EXPECT_EQ(believed(k3, {0xFFFF, 0xFFFF, 0xFFFF, 5, 5, 5}),
              (std::vector<Word>{0, 0, 0xFFFF, 0xFFFF, 0xFFFF, 5}));
}

// 0001FC00 -> 00020100 read as 00010100, by an answer that comes twice. It is near what was believed before.
TEST(WordGate, APositionFarFromTheReadBeforeIsNotBelievedBecauseItIsNearAnOlderOne)
{
    EXPECT_EQ(believed(k3, {0x1'4000, 0x1'4000, 0x1'4000, 0x1'F800, 0x1'FC00, 0x1'0100, 0x1'0100}),
              (std::vector<Word>{0, 0, 0x1'4000, 0x1'4000, 0x1'4000, 0x1'4000, 0x1'4000}));
}

// A confirmation C20000FF that begins while the word is read, in either order.
TEST(WordGate, AWordTornBetweenPositionAndHandshakeIsNotBelieved)
{
    EXPECT_EQ(believed(k3, {0x12'3450, 0x12'3456, 0x12'00FF, 0xC200'00FF, 0xC200'00FF}),
              (std::vector<Word>{0, 0, 0, 0, 0xC200'00FF}));
    EXPECT_EQ(believed(k3, {0x12'3456, 0x12'3456, 0x12'3456, 0xC200'3456, 0xC200'00FF, 0xC200'00FF}),
              (std::vector<Word>{0, 0, 0x12'3456, 0x12'3456, 0x12'3456, 0xC200'00FF}));
    // and back
    EXPECT_EQ(believed(k3, {0xC200'00FF, 0xC200'00FF, 0x12'00FF, 0x12'3456, 0x12'3456, 0x12'3456}),
              (std::vector<Word>{0, 0xC200'00FF, 0xC200'00FF, 0xC200'00FF, 0xC200'00FF, 0x12'3456}));
}

TEST(WordGate, WithoutAProfileOnlyEqualReadsCount)
{
    EXPECT_EQ(believed(WordGate(std::nullopt, 2, {}), {100, 110, 120, 120}),
              (std::vector<Word>{0, 0, 0, 120}));
}

TEST(WordGate, OneRegisterCannotBeTorn)
{
    EXPECT_EQ(believed(WordGate(profile::k1, 1, {}), {100, 50'000, 7}), (std::vector<Word>{100, 50'000, 7}));
}

TEST(WordGate, AfterAnInterruptionWhatWasReadBeforeSaysNothing)
{
    WordGate gate = k3;
    for (int i = 0; i < 3; ++i)
        gate.take(100, {});
    EXPECT_TRUE(gate.hasWord());
    gate.forget();
    EXPECT_FALSE(gate.hasWord());
    EXPECT_FALSE(gate.take(100, {}));
}

} // namespace
} // namespace codewheel
