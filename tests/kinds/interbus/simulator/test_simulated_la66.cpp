// SPDX-License-Identifier: GPL-3.0-or-later
#include "handshake_rows.h"
#include "kinds/interbus/simulator/simulated_la66.h"

#include <limits>
#include <random>

// LA-66 manual: the words are literally those of chapters 2 to 4. With normal timing the answer is in IN in
// the third cycle of the service bit.
namespace codewheel {
namespace {

constexpr double rod = 500; // mm; 50 000 steps of 0.01 mm as delivered

class SimulatedLa66Test : public testing::Test
{
protected:
    SimulatedLa66Test() { moveTo(123.45); }

    void moveTo(double millimetres) { m_rod.moveMagnetTo(millimetres); }
    std::string shown() { return hex8(m_rod.cycle(0)); }
    // OUT without the service bit, with it until the answer comes, and back.
    Word answer(Word out)
    {
        const Word in = send(m_rod, {out & 0x7FFF'FFFF, out});
        send(m_rod, {out & 0x7FFF'FFFF, 0x0000'0000});
        return in;
    }

    SimulatedLa66 m_rod{rod};
};

TEST_F(SimulatedLa66Test, FiveStepsOfTheHandshake)
{
    play(m_rod, {
                    {0x0000'0000, 0x0000'3039, 3}, // 1: normal mode, IN is the position
                    {0x4200'1388, 0x0000'3039, 2}, // 2: service and data, the service bit still 0
                    {0xC200'1388, 0x0000'3039, 2}, //    and with it
                    {0xC200'1388, 0xC200'1388, 3}, // 3: done and acknowledged
                    {0x4200'1388, 0xC200'1388},    // 4: the host ends it
                    {0x4200'1388, 0x0000'04D2},    // 5: and so does the encoder; 0.1 mm a step
                    {0x0000'0000, 0x0000'04D2, 2},
                });
}

TEST_F(SimulatedLa66Test, EachServiceIsWrittenAndRead)
{
    struct Row
    {
        Word out;
        Word in;
    };
    const Row rows[] = {
        {0x8100'0000, 0x8100'0000}, {0xC100'0001, 0xC100'0001}, {0x8100'0000, 0x8100'0001},
        {0x8200'0000, 0x8200'C350}, {0xC200'1388, 0xC200'1388}, {0x82FF'FFFF, 0x8200'1388},
        {0x8400'0000, 0x8400'0000}, {0xC4FF'FFFF, 0xC4FF'FFFF}, {0x8400'0000, 0x84FF'FFFF},
        {0xC600'03E8, 0xC600'03E8}, {0x8800'0000, 0x8800'0000},
    };
    for (const Row &row : rows)
        EXPECT_EQ(hex8(answer(row.out)), hex8(row.in)) << hex8(row.out);
    EXPECT_EQ(m_rod.eepromWrites(), 4);
}

TEST_F(SimulatedLa66Test, WhatIsNoServiceComesBackWithTheErrorBitAndChangesNothing)
{
    const Word refused[] = {
        0xC100'0002,                                        // direction
        0xC200'0000,                                        // no length
        0x8600'0000,                                        // write only
        0xC800'0000,                                        // read only
        0xC000'0001, 0x8000'0000, 0xC300'0001, 0x8F00'0000, // no service
        0x9200'0000, 0xD200'1388,                           // D28
    };
    for (const Word out : refused)
        EXPECT_EQ(hex8(answer(out)), hex8(out | 0x2000'0000)) << hex8(out);
    EXPECT_EQ(hex8(answer(0xE200'1388)), "E2001388");
    EXPECT_EQ(hex8(answer(0x8200'0000)), "8200C350");
    EXPECT_EQ(hex8(answer(0x8100'0000)), "81000000");
    EXPECT_EQ(m_rod.eepromWrites(), 0);
    EXPECT_EQ(shown(), "00003039");
}

TEST_F(SimulatedLa66Test, InNormalModeOutHasNoEffect)
{
    for (const Word out : {0x4200'1388u, 0x4600'0000u, 0x7FFF'FFFFu, 0x0000'0001u})
        play(m_rod, {{out, 0x0000'3039, 5}});
    EXPECT_EQ(m_rod.eepromWrites(), 0);
}

TEST_F(SimulatedLa66Test, ActsOnTheEdgeAloneAndIgnoresOutWhileTheServiceBitStands)
{
    EXPECT_EQ(hex8(send(m_rod, {0x4200'1388, 0xC200'1388})), "C2001388");
    EXPECT_EQ(hex8(send(m_rod, {0xC200'C350, 0x8800'0000, 0xC600'0000})), "C2001388");
    EXPECT_EQ(hex8(send(m_rod, {0x0000'0000})), "000004D2");
    EXPECT_EQ(m_rod.eepromWrites(), 1);
}

TEST_F(SimulatedLa66Test, AServiceBitThatIsTakenBackEarlyIsAnsweredForOneCycle)
{
    play(m_rod, {{0x4200'1388, 0x0000'3039},
                 {0xC200'1388, 0x0000'3039},
                 {0x0000'0000, 0x0000'3039},
                 {0x0000'0000, 0xC200'1388},
                 {0x0000'0000, 0x0000'04D2}});
}

TEST_F(SimulatedLa66Test, CountsDownTowardsTheEndOfTheRod)
{
    answer(0xC100'0001);
    EXPECT_EQ(shown(), hex8(50'000 - 12'345));
    moveTo(0);
    EXPECT_EQ(shown(), hex8(50'000));
    moveTo(500);
    EXPECT_EQ(shown(), "00000000");
}

TEST_F(SimulatedLa66Test, PresetAdjustmentSetsThePositionWithin24Bits)
{
    answer(0xC600'03E8);
    EXPECT_EQ(shown(), "000003E8");
    moveTo(123.55);
    EXPECT_EQ(shown(), "000003F2");
    moveTo(0);
    EXPECT_EQ(shown(), hex8((1'000u - 12'345u) & 0x00FF'FFFF));
}

TEST_F(SimulatedLa66Test, ALostMagnetKeepsThePositionAndSetsTheErrorBit)
{
    m_rod.setMagnetInRange(false);
    moveTo(400);
    EXPECT_EQ(shown(), "20003039");
    EXPECT_EQ(hex8(answer(0x8800'0000)), "88000020");
    EXPECT_EQ(shown(), "20003039") << "the cause is not gone";
    EXPECT_EQ(hex8(answer(0xC200'1388)), "C2001388") << "services go on";
    EXPECT_EQ(shown(), "200004D2");

    m_rod.setMagnetInRange(true);
    moveTo(400);
    EXPECT_EQ(shown(), "20000FA0") << "the error bit stays until the error status is read";
    EXPECT_EQ(hex8(answer(0x8800'0000)), "88000020");
    EXPECT_EQ(shown(), "00000FA0");
    EXPECT_EQ(hex8(answer(0x8800'0000)), "88000000");
}

TEST_F(SimulatedLa66Test, KeepsEverythingOverAPowerCycle)
{
    answer(0xC200'1388);
    answer(0xC400'0007);
    answer(0xC600'0064);
    m_rod.powerCycle();
    play(m_rod, {{0x0000'0000, 0x0000'0000, 50}, {0x0000'0000, 0x0000'0064}});
    EXPECT_EQ(hex8(answer(0x8400'0000)), "84000007");
    EXPECT_EQ(hex8(answer(0x8200'0000)), "82001388");
}

TEST_F(SimulatedLa66Test, AServiceBitThatStandsAtPowerUpIsNoEdge)
{
    m_rod.setPower(false);
    play(m_rod, {{0xC200'1388, 0x0000'0000, 3}});
    m_rod.setPower(true);
    play(m_rod, {{0xC200'1388, 0x0000'3039, 10}});
    EXPECT_EQ(hex8(answer(0x8200'0000)), "8200C350");
}

TEST_F(SimulatedLa66Test, ASlowOneAnswersAfterFiftyTimesAsLong)
{
    m_rod.setSlow(true);
    play(m_rod, {{0x0200'0000, 0x0000'3039}, {0x8200'0000, 0x0000'3039, 100}, {0x8200'0000, 0x8200'C350}});
    EXPECT_TRUE(m_rod.rodState()->slow);
}

TEST_F(SimulatedLa66Test, TheMagnetTurnsRoundAtTheEnds)
{
    moveTo(499.9);
    m_rod.setMagnetSpeed(100); // 0.1 mm a cycle
    m_rod.cycle(0);
    EXPECT_EQ(shown(), "0000C350");
    EXPECT_EQ(shown(), hex8(49'990));
    EXPECT_LT(m_rod.rodState()->millimetresPerSecond, 0);
    for (int i = 0; i < 10'000; ++i)
        m_rod.cycle(0);
    EXPECT_EQ(shown(), hex8(49'980)) << "there and back, and it does not drift";
}

TEST(RodMagnet, StaysOnTheRodWhateverIsAsked)
{
    RodMagnet magnet(rod);
    for (const double place : {-1.0, 501.0, 1e300, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
        magnet.moveTo(place);
        magnet.setSpeed(place);
        for (int i = 0; i < 200; ++i) {
            magnet.advance();
            ASSERT_GE(magnet.millimetres(), 0);
            ASSERT_LE(magnet.millimetres(), rod);
        }
        EXPECT_LE(std::abs(magnet.speed()), RodMagnet::fastest);
    }
}

bool isDocumented(Word in)
{
    if ((in & 0x8000'0000) == 0) // position, with or without the error bit
        return (in & 0x5F00'0000) == 0;
    if ((in & 0x2000'0000) != 0) // refused: OUT as it came
        return true;
    switch (in >> 24) {
    case 0xC1:
    case 0x81:
        return (in & 0x00FF'FFFF) <= 1;
    case 0xC2:
    case 0x82:
        return (in & 0x00FF'FFFF) != 0;
    case 0xC4:
    case 0x84:
    case 0xC6:
        return true;
    case 0x88:
        return (in & 0x00FF'FFDF) == 0;
    default:
        return false;
    }
}

Word randomWord(std::mt19937 &random)
{
    const Word services[] = {0xC1, 0x81, 0xC2, 0x82, 0xC4, 0x84, 0xC6, 0x86, 0xC8, 0x88, 0x41, 0x02};
    const auto any = static_cast<Word>(random());
    if (random() % 3 == 0)
        return any;
    return services[random() % std::size(services)] << 24 | (any & 0x00FF'FFFF) >> random() % 24;
}

TEST(RandomWords, LeaveAnLa66InADocumentedStateFromWhichItComesBack)
{
    std::mt19937 random(66); // seeded: the same words in each run
    SimulatedLa66 encoder(rod);
    for (int i = 0; i < 1'000'000; ++i) {
        const Word out = randomWord(random);
        for (unsigned cycle = 0; cycle < 1 + random() % 5; ++cycle) {
            const Word in = encoder.cycle(out);
            ASSERT_TRUE(isDocumented(in)) << "word " << i << ": " << hex8(out) << " / " << hex8(in);
        }
        switch (random() % 5'000) {
        case 0:
            encoder.powerCycle();
            break;
        case 1:
            encoder.setMagnetInRange(random() % 2 == 0);
            break;
        case 2:
            encoder.setMagnetSpeed(static_cast<double>(random() % 20'000) - 10'000);
            break;
        default:
            break;
        }
        if (i % 500 != 499)
            continue;
        for (int off = 0; off < 60; ++off)
            encoder.cycle(0); // a power cycle may be under way
        encoder.setMagnetInRange(true);
        encoder.setMagnetSpeed(0);
        encoder.moveMagnetTo(123.45);
        for (const Word service : {0x4100'0000u, 0x4200'C350u, 0x4600'3039u, 0x0800'0000u})
            send(encoder, {service, service | 0x8000'0000, 0x0000'0000});
        ASSERT_EQ(hex8(send(encoder, {0x0000'0000})), "00003039") << "word " << i;
    }
}

} // namespace
} // namespace codewheel
