// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/baumer_k3.h"

namespace codewheel {
namespace {

class BaumerHandshake : public testing::Test
{
protected:
    BaumerK3 m_encoder{{8192, 4096}, 12'345};
};

// Baumer manual 6, example 1: the previous number, 0 at first, while it processes
TEST_F(BaumerHandshake, Example1ParameterTransfer)
{
    play(m_encoder, {
                        {0x0000'0000, pos},            // 1
                        {0x0200'00FF, pos, 2},         // 2-3
                        {0x0200'00FF, 0xC000'00FF, 2}, // 4-5
                        {0x0200'00FF, 0xC200'00FF, 2}, // 6
                        {0x8000'0000, 0xC200'00FF},    // 7
                        {0x8000'0000, 0x0000'0180},    // 8
                        {0x0000'0000, 0x0000'0180},    // 9
                    });
}

// Baumer manual 6, example 2: 20 000 revolutions do not harmonize
TEST_F(BaumerHandshake, Example2NonHarmonizingParameters)
{
    play(m_encoder, {
                        {0x0000'0000, pos},            // 1
                        {0x0400'4E20, pos, 2},         // 2-3
                        {0x0400'4E20, 0xC000'4E20, 2}, // 4-5
                        {0x0400'4E20, 0xC400'4E20},    // 6
                        {0x0600'0001, 0xC400'4E20, 2}, // 7-8: old
                        {0x0600'0001, 0xC400'0001, 2}, // 9
                        {0x0600'0001, 0xC600'0001},    // 10
                        {0x8000'0000, 0xC600'0001},    // 11
                        {0x8000'0000, 0x8200'0000, 3}, // 12
                    });
    // ... and every further run fails until it is corrected.
    play(m_encoder, {{0x0000'0000, 0x8200'0000}, {0x8000'0000, 0x8200'0000, 3}});
    play(m_encoder, {
                        {0x0400'0001, 0x8200'0000, 2},
                        {0x0400'0001, 0xC000'0001, 2},
                        {0x0400'0001, 0xC400'0001},
                        {0x8000'0000, 0xC400'0001},
                        {0x8000'0000, pos},
                    });
}

TEST_F(BaumerHandshake, TheNumberConfirmedLastMustNotComeAgain)
{
    play(m_encoder, {
                        {0x0200'00FF, pos, 2},
                        {0x0200'00FF, 0xC000'00FF, 2},
                        {0x0200'00FF, 0xC200'00FF},
                        {0x0200'0100, 0xC200'00FF, 6}, // ignored
                        {0x0000'0000, 0xC200'00FF, 3},
                        {0x0200'0100, 0xC200'00FF, 6},
                        {0x0400'0001, 0xC200'00FF, 2}, // another one, then the first again
                        {0x0400'0001, 0xC200'0001, 2},
                        {0x0400'0001, 0xC400'0001},
                        {0x0200'0100, 0xC400'0001, 2},
                        {0x0200'0100, 0xC400'0100, 2},
                        {0x0200'0100, 0xC200'0100},
                        {0x8000'0000, 0xC200'0100},
                        {0x8000'0000, 0x0000'0181},    // floor(12345 x 256 / 8192) = 385
                        {0x0200'00FF, 0x0000'0181, 2}, // after leaving the parameterization
                        {0x0200'00FF, 0xC000'00FF, 2},
                        {0x0200'00FF, 0xC200'00FF},
                    });
}

TEST_F(BaumerHandshake, AfterAnErrorAnyNumberMayFollow)
{
    play(m_encoder, {
                        {0x0600'0007, pos, 2},
                        {0x0600'0007, 0xC000'0007, 2},
                        {0x0600'0007, 0xC600'0007},
                        {0x8000'0000, 0xC600'0007},
                        {0x8000'0000, 0x8200'0000},
                        {0x0600'0003, 0x8200'0000, 2},
                        {0x0600'0003, 0xC000'0003, 2},
                        {0x0600'0003, 0xC600'0003},
                        {0x8000'0000, 0xC600'0003},
                        {0x8000'0000, pos},
                    });
}

TEST_F(BaumerHandshake, UnknownNumbersAreConfirmedAndRefusedAtRun)
{
    for (const Word word :
         {0x1000'0001u, 0x1200'0001u, 0x1400'0001u, 0x1600'0001u, 0x1800'0001u, 0x1A00'0001u, 0x1C00'0001u}) {
        play(m_encoder, {
                            {0x0000'0000, pos},
                            {word, pos, 2},
                            {word, 0xC000'0001, 2},
                            {word, 0xC000'0000 | word},
                            {0x8000'0000, 0xC000'0000 | word},
                            {0x8000'0000, 0x8400'0000, 2},
                            {0x0000'0000, 0x8400'0000},
                            {0x8000'0000, 0x8400'0000},
                            {0x8000'0000, pos},
                        });
    }
    EXPECT_EQ(m_encoder.eepromWrites(), 0);
}

TEST_F(BaumerHandshake, D29MeansNothing)
{
    play(m_encoder, {
                        {0x2000'0000, pos, 4},
                        {0x2021'0009, pos, 4}, // goes on showing a position
                        {0x2200'00FF, pos, 2},
                        {0x2200'00FF, 0xC000'00FF, 2},
                        {0x2200'00FF, 0xC200'00FF},
                        {0xA000'0000, 0xC200'00FF},
                        {0xA000'0000, 0x0000'0180},
                    });
}

struct CodingRow
{
    Word word;
    Word position;
};

// Baumer 5: 200 steps, 5 turns; raw 12345 is x = 301
TEST_F(BaumerHandshake, Chapter5Codings)
{
    send(m_encoder, {0x0200'00C8, 0x0400'0001, 0x1E00'0005, 0x8000'0000, 0x0000'0000});
    const CodingRow rows[] = {
        {0x0600'0003, 0x0000'012D}, {0x0600'0004, 0x0000'02BA}, // 301, 698
        {0x0600'0001, 0x0000'012D}, {0x0600'0002, 0x01FF'FED2}, // 301, -302
        {0x0600'0005, 0x0000'01BB}, {0x0600'0006, 0x0000'03E7}, // Gray of 301, 698
    };
    for (const CodingRow &row : rows)
        EXPECT_EQ(hex8(send(m_encoder, {row.word, 0x8000'0000, 0x0000'0000})), hex8(row.position))
            << hex8(row.word);
    m_encoder.turnTo(5 * 8192 + 12'345); // one range further on
    EXPECT_EQ(send(m_encoder, {0x0600'0003, 0x8000'0000, 0x0000'0000}), 0x0000'012D);
}

// Baumer 5: NPV = PW - API; PI = API + NPV + O
TEST_F(BaumerHandshake, Chapter5PresetAndOffset)
{
    send(m_encoder, {0x0200'00C8, 0x1E00'0005, 0x0800'0064, 0x8000'0000, 0x0000'0000});
    m_encoder.turnTo(12'288); // API 300
    play(m_encoder, {{0x4000'0000, 0x0000'012C, 2}, {0x4000'0000, 0x0000'0064, 2}});
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0C00'0007, 0x8000'0000}), 0x0000'006B);
    m_encoder.turnBy(4096); // half a turn, 100 steps
    EXPECT_EQ(send(m_encoder, {0x0000'0000}), 0x0000'00CF);
    EXPECT_EQ(send(m_encoder, {0x4000'0000}), 0x0000'006B); // PW + O, any number of times
    EXPECT_EQ(send(m_encoder, {0x0000'0000, 0x0C00'03E8, 0x8000'0000}), 0x8200'0000); // O = total
}

TEST_F(BaumerHandshake, ResetGivesTheFactorySettings)
{
    send(m_encoder,
         {0x0200'00C8, 0x1E00'0005, 0x0600'0006, 0x0C00'0005, 0x0A00'0005, 0x8000'0000, 0x0000'0000});
    EXPECT_EQ(send(m_encoder, {0x0E00'0000}), 0xCE00'0000);
    EXPECT_EQ(send(m_encoder, {0x8000'0000}), pos);
}

// Baumer 7: disturbance 13, reported by the run that is to store
TEST_F(BaumerHandshake, Chapter7AWornOutEepromFailsTheRunThatStores)
{
    m_encoder.setEepromWornOut(true);
    EXPECT_EQ(hex8(send(m_encoder, {0x0200'00FF})), "C20000FF");
    EXPECT_EQ(hex8(send(m_encoder, {0x8000'0000})), "9A000000");
    EXPECT_EQ(hex8(send(m_encoder, {0x0000'0000, 0x8000'0000})), "9A000000"); // the set stays pending
    m_encoder.setEepromWornOut(false);
    EXPECT_EQ(hex8(send(m_encoder, {0x0000'0000})), "9A000000");
    EXPECT_EQ(hex8(send(m_encoder, {0x8000'0000})), "00000180");
}

// Baumer 7: "if an error occurs during the operation state (e.g. 15), the encoder automatically switches"
TEST_F(BaumerHandshake, Chapter7AFaultyCodeDiscShowsByItselfUntilItIsGoneAndRun)
{
    play(m_encoder, {{0x0000'0000, pos}});
    m_encoder.setCodeDiscFaulty(true);
    play(m_encoder,
         {{0x0000'0000, 0x9E00'0000, 5}, {0x8000'0000, 0x9E00'0000, 5}, {0x0000'0000, 0x9E00'0000}});
    m_encoder.setCodeDiscFaulty(false);
    play(m_encoder, {{0x0000'0000, 0x9E00'0000, 5}, {0x8000'0000, 0x9E00'0000}, {0x8000'0000, pos, 2}});
}

TEST_F(BaumerHandshake, Chapter7AFaultyCodeDiscIsFoundAtPowerUp)
{
    m_encoder.setPower(false);
    m_encoder.setCodeDiscFaulty(true);
    EXPECT_EQ(m_encoder.cycle(0), 0u);
    m_encoder.setPower(true);
    for (int cycle = 0; cycle < 30; ++cycle)
        m_encoder.cycle(0);
    EXPECT_EQ(hex8(m_encoder.cycle(0)), "9E000000");
    m_encoder.setCodeDiscFaulty(false);
    EXPECT_EQ(hex8(send(m_encoder, {0x8000'0000})), hex8(pos));
}

} // namespace
} // namespace codewheel
