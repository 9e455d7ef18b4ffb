// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "journal/eeprom_cost.h"
#include "ring/bus_session.h"
#include "simulator/training_bus.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct Row
{
    int soFar;
    int planned;
    EepromConcern concern;
};

TEST(EepromConcern, RisesWithWhatTheManualStates)
{
    const Capabilities fraba{.eepromBudget = 200, .eepromLimit = 500};
    for (const Row &row : {Row{0, 4, EepromConcern::none}, Row{145, 4, EepromConcern::none},
                           Row{146, 4, EepromConcern::warning}, Row{150, 1, EepromConcern::warning},
                           Row{196, 4, EepromConcern::warning}, Row{197, 4, EepromConcern::question},
                           Row{200, 1, EepromConcern::question}, Row{496, 4, EepromConcern::question},
                           Row{497, 4, EepromConcern::typed}, Row{10'000, 1, EepromConcern::typed},
                           Row{10'000, 0, EepromConcern::none}})
        EXPECT_EQ(eepromConcern(row.soFar, row.planned, fraba), row.concern)
            << row.soFar << '+' << row.planned;
}

TEST(EepromConcern, IsSilentWhereTheManualIs)
{
    EXPECT_EQ(eepromConcern(1'000'000, 4, Capabilities{}), EepromConcern::none);
    EXPECT_EQ(eepromConcern(1'000'000, 4, Capabilities{.eepromBudget = 100, .eepromLimit = {}}),
              EepromConcern::question);
    EXPECT_EQ(eepromConcern(99, 2, Capabilities{.eepromBudget = {}, .eepromLimit = 100}),
              EepromConcern::typed);
}

class EepromCost : public testing::Test
{
protected:
    EepromCost() { EXPECT_TRUE(bus.open(BusSession::Start::operating)); }
    int of(int segment, const Job &job) const { return mostEepromWrites(*bus.encoder({segment, 0}), job); }

    const Catalog catalog = Catalog::builtIn();
    BusSession bus{makeTrainingBus(catalog).link, catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
};

TEST_F(EepromCost, IsTheMostAJobMayWrite)
{
    constexpr int fraba = 1;
    EXPECT_EQ(of(fraba, ReadParameters{{Parameter::steps}}), 0);
    EXPECT_EQ(of(fraba, WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}},
                                        .previous = {},
                                        .initialisePreset = true}),
              3);
    EXPECT_EQ(of(fraba, SetPreset{}), 1);
    EXPECT_EQ(of(fraba, SetPreset{.value = 7, .command = PresetCommand::manufacturer}), 2);
    EXPECT_EQ(of(fraba, ResetToDefault{}), 2); // it may be in a cam program that was changed
    EXPECT_EQ(of(2, ResetToDefault{}), 1);
    EXPECT_EQ(of(fraba, ReadCams{{1, 2, 3}, {}}), 4);
    EXPECT_EQ(of(fraba, SendWords{{0x020000FF, 0x80000000, 0}}), 1);
    EXPECT_EQ(of(2, SwitchMode{}), 0);
}

TEST_F(EepromCost, SaysWhoseWritesAndByWhat)
{
    const EepromCount count{.writes = 12,
                            .perhaps = 4,
                            .since = QDateTime(QDate(2026, 3, 1), QTime(12, 0)),
                            .by = CountedBy::serialNumber,
                            .serialNumber = QStringLiteral("4711")};
    EXPECT_EQ(
        eepromCountText(count),
        QStringLiteral("EEPROM writes by this program since 1 Mar 2026: 12 (and perhaps 4 more, which it "
                       "began before it was ended), counted by the serial number 4711 the encoder told."));
    EXPECT_EQ(eepromCountBrief(count), QStringLiteral("12-16 writes from here since 1 Mar 2026"));
    EXPECT_EQ(eepromCountBrief({.writes = 3}), QStringLiteral("3 writes from here"));
}

} // namespace
} // namespace codewheel
