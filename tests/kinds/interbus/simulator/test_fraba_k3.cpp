// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/fraba_k3.h"

namespace codewheel {
namespace {

class FrabaHandshake : public testing::Test
{
protected:
    FrabaK3 m_encoder{thirteenPlusTwelve, 12'345, {}};
};

// FRABA manual 5.3: the example with 255 steps, row by row and cycle by cycle
TEST_F(FrabaHandshake, Manual53ParameterizationOf255Steps)
{
    play(m_encoder, {
                        {0x0000'0000, pos},            // 1
                        {0x0200'00FF, pos, 2},         // 2-3
                        {0x0200'00FF, 0xC200'00FF, 2}, // 4-5
                        {0x0200'00FF, 0xC200'00FF},    // 6
                        {0x0400'0001, 0xC200'00FF, 2}, // 4': old confirmation
                        {0x0400'0001, 0xC400'0001, 3}, // 5'-6'
                        {0x0600'0003, 0xC400'0001, 2}, // 4''
                        {0x0600'0003, 0xC600'0003, 3}, // 5''-6''
                        {0x0800'0000, 0xC600'0003, 2}, // 4'''
                        {0x0800'0000, 0xC800'0000, 3}, // 5'''-6'''
                        {0x8000'0000, 0xC800'0000},    // 7
                        {0x8000'0000, pos255},         // 8
                        {0x0000'0000, pos255, 2},      // 9
                        {0x4000'0000, pos255, 2},      // preset = 0
                        {0x4000'0000, 0x0000'0000},
                        {0x0000'0000, 0x0000'0000, 2},
                    });
}

TEST_F(FrabaHandshake, AnswersBeforeTheValuesAreCheckedAndTakesTheNextWordAfterProcessing)
{
    play(m_encoder, {
                        {0x0200'00FF, pos, 2},
                        {0x0200'00FF, 0xC200'00FF},
                        {0x0400'0001, 0xC200'00FF, 2}, // stays while 1 is still being processed
                        {0x0400'0001, 0xC400'0001, 3},
                    });
}

TEST_F(FrabaHandshake, AWordThatStoodForOneCycleIsNotTaken)
{
    play(m_encoder, {{0x0200'00FF, pos}, {0x0000'0000, pos, 5}, {0x0200'00FF, pos}, {0x8000'0000, pos, 5}});
}

TEST_F(FrabaHandshake, DataWithD24SetAreConfirmedWithTheFirstByteC3)
{
    play(m_encoder, {{0x0300'0000, pos, 2}, {0x0300'0000, 0xC300'0000, 5}});
}

// Values outside their own range: Cp while it is processing, then 82000000
TEST_F(FrabaHandshake, WrongDataAreRefusedAfterProcessing)
{
    for (const Word word :
         {0x0200'0000u, 0x0400'0000u, 0x0400'1001u, 0x0600'0002u, 0x0600'0005u, 0x0E00'0001u}) {
        play(m_encoder, {
                            {0x0000'0000, pos, 2},
                            {word, pos, 2},
                            {word, 0xC000'0000 | word, 2},
                            {word, 0x8200'0000, 3},
                            {0x8000'0000, 0x8200'0000},
                            {0x8000'0000, pos, 2}, // nothing wrong was kept
                        });
    }
    EXPECT_EQ(m_encoder.eepromWrites(), 0);
}

TEST_F(FrabaHandshake, UnknownNumbersAreRefusedWithoutAConfirmation)
{
    for (const Word word : {0x0C00'0000u, 0x1000'0000u, 0x1200'0005u, 0x1400'0000u, 0x1600'0000u,
                            0x1800'0000u, 0x1A00'0000u, 0x1C00'0000u, 0x1E00'1000u}) {
        play(m_encoder, {
                            {0x0000'0000, pos, 2},
                            {word, pos, 2},
                            {word, 0x8400'0000, 3},
                            {0x8000'0000, 0x8400'0000},
                            {0x8000'0000, pos},
                        });
    }
}

TEST_F(FrabaHandshake, UndefinedWordsAreRefusedAndNothingIsExecuted)
{
    send(m_encoder, {0x0800'0064, 0x8000'0000, 0x0000'0000}); // a preset that could be activated
    for (const Word word : {0x4000'0001u, 0x4200'0000u, 0x6000'0001u, 0x6200'0000u, 0x2000'0000u,
                            0x2200'00FFu, 0x2040'0002u, 0x2010'0000u, 0x2020'0000u, 0x2001'0000u}) {
        play(m_encoder, {
                            {0x0000'0000, pos, 2},
                            {word, pos, 2},
                            {word, 0x8400'0000, 2},
                            {0x8000'0000, 0x8400'0000},
                            {0x8000'0000, pos},
                        });
    }
}

TEST_F(FrabaHandshake, AnErrorIsLeftByParameterWordsAndRun)
{
    play(m_encoder, {
                        {0x0600'0007, pos, 2},
                        {0x0600'0007, 0xC600'0007, 2},
                        {0x0600'0007, 0x8200'0000, 2},
                        {0x0600'0003, 0x8200'0000, 2},
                        {0x0600'0003, 0xC600'0003, 3},
                        {0x8000'0000, 0xC600'0003},
                        {0x8000'0000, pos},
                    });
}

// 9000 steps per turn are within the parameter's range, but more than the disc has.
TEST_F(FrabaHandshake, RunFailsUntilThePendingSetIsCorrected)
{
    play(m_encoder, {
                        {0x0200'2328, pos, 2},
                        {0x0200'2328, 0xC200'2328, 3},
                        {0x8000'0000, 0xC200'2328},
                        {0x8000'0000, 0x8200'0000, 3},
                        {0x0000'0000, 0x8200'0000, 3},
                        {0x8000'0000, 0x8200'0000, 3}, // again
                        {0x0600'0003, 0x8200'0000, 2}, // another parameter does not help
                        {0x0600'0003, 0xC600'0003, 3},
                        {0x8000'0000, 0xC600'0003},
                        {0x8000'0000, 0x8200'0000},
                        {0x0200'00FF, 0x8200'0000, 2},
                        {0x0200'00FF, 0xC200'00FF, 3},
                        {0x8000'0000, 0xC200'00FF},
                        {0x8000'0000, pos255, 2},
                    });
}

TEST_F(FrabaHandshake, APresetBeyondTheTotalRangeIsRefusedAtRun)
{
    // 255 x 4096 = 1044480 = FF000h
    EXPECT_EQ(send(m_encoder, {0x0200'00FF, 0x080F'F000, 0x8000'0000}), 0x8200'0000);
    EXPECT_EQ(send(m_encoder, {0x080F'EFFF, 0x8000'0000}), pos255);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x4000'0000}), 0x000F'EFFF);
}

TEST_F(FrabaHandshake, RunActsOnItsEdgeOnlyWhateverTheOtherBitsAre)
{
    play(m_encoder, {
                        {0x8000'0000, pos, 4}, // in operation: nothing
                        {0x8200'00FF, pos, 4}, // numbers are ignored while D31 is 1
                        {0xC000'0000, pos, 4},
                        {0x0200'00FF, pos, 2},
                        {0x0200'00FF, 0xC200'00FF, 3},
                        {0x8400'0001, 0xC200'00FF}, // an edge, with other bits set
                        {0x8400'0001, pos255},
                        {0x0600'0004, pos255, 2},
                        {0x0600'0004, 0xC600'0004, 3},
                    });
}

TEST_F(FrabaHandshake, RunDuringProcessingTakesEffectWhenProcessingEnds)
{
    play(m_encoder, {
                        {0x0200'00FF, pos, 2},
                        {0x8000'0000, 0xC200'00FF, 2},
                        {0x8000'0000, pos255, 2},
                    });
}

TEST_F(FrabaHandshake, RunDuringProcessingDoesNotHideARefusal)
{
    play(m_encoder, {
                        {0x0400'0000, pos, 2},
                        {0x8000'0000, 0xC400'0000, 2},
                        {0x8000'0000, 0x8200'0000, 3},
                        {0x0000'0000, 0x8200'0000, 2},
                        {0x8000'0000, 0x8200'0000},
                        {0x8000'0000, pos},
                    });
}

TEST_F(FrabaHandshake, ARefusalIsSeenForACycleBeforeTheNextWordIsTaken)
{
    m_encoder.setSlow(true);
    play(m_encoder, {
                        {0x0400'0000, pos, 2},
                        {0x0600'0003, 0xC400'0000, 100},
                        {0x0600'0003, 0x8200'0000},
                        {0x0600'0003, 0xC600'0003, 101},
                    });
}

TEST_F(FrabaHandshake, TheSameNumberMayComeAgain)
{
    play(m_encoder, {
                        {0x0200'00FF, pos, 2},
                        {0x0200'00FF, 0xC200'00FF, 3},
                        {0x0200'0100, 0xC200'00FF, 2},
                        {0x0200'0100, 0xC200'0100, 3},
                    });
}

TEST_F(FrabaHandshake, CounterclockwiseCountsDown)
{
    // total 33554432; 33554431 - 12345
    EXPECT_EQ(send(m_encoder, {0x0600'0004, 0x8000'0000}), 0x01FF'CFC6);
    m_encoder.turnBy(1);
    EXPECT_EQ(m_encoder.cycle(0), 0x01FF'CFC5);
}

TEST_F(FrabaHandshake, TheZeroPointShiftingIsAdded)
{
    EXPECT_EQ(send(m_encoder, {0x0A00'0007, 0x8000'0000}), pos + 7);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0200'00FF, 0x0A0F'F000, 0x8000'0000}), 0x8200'0000);
}

TEST_F(FrabaHandshake, TheZeroPointShiftingIsKeptModuloTheNewTotalRange)
{
    // 1FFFFFFh mod 1044480 = 2^25 - 1 - 32 x 1044480 = 131071
    EXPECT_EQ(send(m_encoder, {0x0BFF'FFFF, 0x8000'0000}), pos - 1);
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0200'00FF, 0x8000'0000}), pos255 + 131'071);
    EXPECT_EQ(send(m_encoder, {0x2021'0005}), 0xA001'FFFF);
}

TEST_F(FrabaHandshake, DefaultIsConfirmedAndActiveAfterRun)
{
    EXPECT_EQ(send(m_encoder, {0x0200'00FF, 0x0600'0004, 0x0A00'0005, 0x8000'0000}), 0x000F'EE84);
    play(m_encoder, {
                        {0x0E00'0000, 0x000F'EE84, 2},
                        {0x0E00'0000, 0xCE00'0000, 3},
                        {0x8000'0000, 0xCE00'0000},
                        {0x8000'0000, pos},
                    });
}

TEST_F(FrabaHandshake, SlowConfirmationTakesFiftyTimesAsLong)
{
    m_encoder.setSlow(true);
    play(m_encoder, {{0x0200'0000, pos, 2}, {0x0200'0000, 0xC200'0000, 100}, {0x0200'0000, 0x8200'0000}});
}

TEST(FrabaTiming, IsSettable)
{
    FrabaK3 encoder(thirteenPlusTwelve, 12'345, {}, {.takenAfter = 5, .processing = 7, .runAfter = 3});
    play(encoder, {
                      {0x0200'0000, pos, 5},
                      {0x0200'0000, 0xC200'0000, 7},
                      {0x0200'0000, 0x8200'0000},
                      {0x8000'0000, 0x8200'0000, 3},
                      {0x8000'0000, pos},
                  });
}

} // namespace
} // namespace codewheel
