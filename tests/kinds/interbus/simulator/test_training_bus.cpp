// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_bus.h"

#include <array>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

class TheTrainingBus : public testing::Test
{
protected:
    // Sends these to 1.0 and 2.0, and 0 to all others. Returns the words from all.
    std::array<Word, 7> exchange(Word first, Word second, int cycles = 1)
    {
        const std::array<Word, 7> out{first, second};
        std::array<Word, 7> in{};
        for (int i = 0; i < cycles; ++i)
            EXPECT_TRUE(m_bus.link->exchange(out, in));
        return in;
    }

    const Catalog m_catalog = Catalog::builtIn();
    TrainingBus m_bus = makeTrainingBus(m_catalog);
    const NodeId m_fraba{"1.0"};
    const NodeId m_baumer{"2.0"};
};

TEST_F(TheTrainingBus, IsThePlantOfItsFile)
{
    const auto structure = m_bus.link->open();
    ASSERT_TRUE(structure);
    const RingStructure plant{
        {NodeId("1.0"), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")},
        {NodeId("2.0"), 0x0237, 2, 2, QStringLiteral("baumer-gxp6w")},
        {NodeId("3.0"), 0x0136, 1, 0, QStringLiteral("fraba-ocd-ib-k1")},
        {NodeId("4.0"), 0x0236, 2, 0, QStringLiteral("fraba-ocd-ib-k2")},
        {NodeId("5.0"), 0x0233, 2, 2, QStringLiteral("tr-la66")},
        {NodeId("6.0"), 0x000C, 0, 0, {}},
        {NodeId("6.1"), 0x02B3, 2, 2, QStringLiteral("fraba-ocd-ib-loop2")},
    };
    EXPECT_EQ(*structure, plant);
    EXPECT_EQ(m_bus.link->readBackOut().value(), std::vector<Word>(7));
}

// 3.0 at 3 rpm with 4096 steps, 4.0 at -6 rpm. 5.0 and 6.1 stand still; 6.0 has no data.
TEST_F(TheTrainingBus, WhatOnlyTellsItsPositionTurnsByItself)
{
    ASSERT_TRUE(m_bus.link->open());
    EXPECT_EQ(exchange(0, 0), (std::array<Word, 7>{0x3039, 0xF'4240, 0x3E8, 0x7A'1200, 0x30D4, 0, 0x1267}));
    const auto later = exchange(0, 0, 10'000);
    EXPECT_EQ(later[2], 1000U + 2048);
    EXPECT_EQ(later[3], 8'000'000U - 4096);
    EXPECT_EQ(later[4], 12'500U);
    EXPECT_EQ(later[5], 0U);
    EXPECT_EQ(later[6], 4711U);
}

TEST_F(TheTrainingBus, TheFrabaStandsStillAndTheBaumerTurns)
{
    ASSERT_TRUE(m_bus.link->open());
    const auto first = exchange(0, 0);
    EXPECT_EQ(first[0], 12'345U);
    const auto later = exchange(0, 0, 60'000); // a minute at 10 rpm
    EXPECT_EQ(later[0], 12'345U);
    EXPECT_EQ(later[1], first[1] + 10 * 8192);
}

// The 255-steps example of FRABA manual 5.3 over the link
TEST_F(TheTrainingBus, TakesThe255StepsExample)
{
    ASSERT_TRUE(m_bus.link->open());
    for (const Word out : {0x0200'00FFu, 0x0400'0001u, 0x0600'0003u, 0x0800'0000u, 0x8000'0000u})
        exchange(out, 0, 5);
    EXPECT_EQ(exchange(0, 0)[0], 384U);
    EXPECT_EQ(m_bus.controls->shafts().at(0).eepromWrites, 4);
    exchange(0x4000'0000, 0, 2);
    EXPECT_EQ(exchange(0x4000'0000, 0)[0], 0U);
    EXPECT_EQ(m_bus.link->readBackOut().value(), (std::vector<Word>{0x4000'0000, 0, 0, 0, 0, 0, 0}));
}

TEST_F(TheTrainingBus, RefusesWhatIsNotConnectedOrOfAnotherSize)
{
    std::array<Word, 7> words{};
    const auto refused = m_bus.link->exchange(words, words);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, RefusalKind::link);
    EXPECT_EQ(refused.error().id, RefusalId::linkFailed);
    EXPECT_FALSE(m_bus.link->readBackOut());
    ASSERT_TRUE(m_bus.link->open());
    EXPECT_TRUE(m_bus.link->exchange(words, words));
    std::array<Word, 3> three{};
    EXPECT_FALSE(m_bus.link->exchange(three, three));
    m_bus.link->close();
    EXPECT_FALSE(m_bus.link->exchange(words, words));
}

TEST_F(TheTrainingBus, TheTrainerSeesAndMovesTheShafts)
{
    ASSERT_TRUE(m_bus.link->open());
    auto shaft = m_bus.controls->shafts().at(0);
    EXPECT_EQ(shaft.number, m_fraba);
    EXPECT_EQ(shaft.raw, 12'345);
    EXPECT_EQ(shaft.stepsPerTurn, 8192);
    EXPECT_EQ(shaft.turns, 4096);
    EXPECT_EQ(shaft.revolutionsPerMinute, 0);
    EXPECT_TRUE(shaft.powered);
    EXPECT_FALSE(shaft.hasBattery);
    EXPECT_EQ(m_bus.controls->shafts().at(1).revolutionsPerMinute, 10);
    EXPECT_TRUE(m_bus.controls->shafts().at(1).hasBattery);

    m_bus.controls->turnTo(m_fraba, 100);
    EXPECT_EQ(exchange(0, 0)[0], 100U);
    m_bus.controls->turnBy(m_fraba, -30);
    EXPECT_EQ(exchange(0, 0)[0], 70U);
    m_bus.controls->setSpeed(m_fraba, 60'000.0 / 8192 * 8); // almost 8 steps per cycle
    exchange(0, 0, 10);
    EXPECT_NEAR(static_cast<double>(m_bus.controls->shafts().at(0).raw), 150, 1);
    m_bus.controls->turnTo(NodeId("9.0"), 5); // no such place
    m_bus.controls->turnTo(NodeId("6.0"), 5); // nothing there that turns
    m_bus.controls->moveMagnetTo(NodeId("5.0"), 250);
    EXPECT_EQ(exchange(0, 0)[4], 25'000U);
    EXPECT_EQ(m_bus.controls->rods().at(0).millimetres, 250);
    m_bus.controls->setSpeed(NodeId("3.0"), 0);
    m_bus.controls->turnTo(NodeId("3.0"), 4095);
    EXPECT_EQ(exchange(0, 0)[2], 0xFFFU);
}

TEST_F(TheTrainingBus, TheTrainerMakesFaults)
{
    ASSERT_TRUE(m_bus.link->open());
    m_bus.controls->setFault(TrainingFault::slowConfirmation, m_fraba, 1);
    EXPECT_TRUE(m_bus.controls->shafts().at(0).slow);
    m_bus.controls->setFault(TrainingFault::batteryLow, m_baumer, 1);
    EXPECT_TRUE(m_bus.controls->shafts().at(1).batteryLow);
    m_bus.controls->setFault(TrainingFault::parametersLost, m_fraba, 1);
    EXPECT_EQ(exchange(0, 0)[0], 0x8600'0000);
    m_bus.controls->setFault(TrainingFault::powerOff, m_fraba, 1);
    EXPECT_FALSE(m_bus.controls->shafts().at(0).powered);
    EXPECT_EQ(exchange(0, 0)[0], 0U);
    m_bus.controls->setFault(TrainingFault::powerOff, m_fraba, 0);
    m_bus.controls->powerCycle(m_baumer);
    const auto in = exchange(0, 0, 80);
    EXPECT_EQ(in[0], 0x8600'0000);
    EXPECT_EQ(in[1], 0x9C00'0000);
}

TEST_F(TheTrainingBus, IsUsedByAnyThread)
{
    ASSERT_TRUE(m_bus.link->open());
    std::jthread trainer([controls = m_bus.controls](const std::stop_token &stop) {
        while (!stop.stop_requested()) {
            controls->turnBy(NodeId("1.0"), 1);
            EXPECT_EQ(controls->shafts().size(), 5U);
            EXPECT_EQ(controls->rods().size(), 1U);
        }
    });
    exchange(0, 0, 2'000);
}

TEST(MovingRing, HasAsManyEncodersAsAskedForAndAllTurn)
{
    const TrainingBus bus = makeMovingRing(128);
    ASSERT_EQ(bus.link->open().value().size(), 128U);
    const std::vector<Word> out(128);
    std::vector<Word> before(128);
    std::vector<Word> after(128);
    ASSERT_TRUE(bus.link->exchange(out, before));
    ASSERT_TRUE(bus.link->exchange(out, after));
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_NE(before[i], after[i]) << i;
}

} // namespace
} // namespace codewheel
