// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "journal/eeprom_cost.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "kinds/interbus/words/device_number.h"
#include "kinds/interbus/words/word_step.h"
#include "tests/support/places.h"

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
                           Row{146, 4, EepromConcern::question}, Row{150, 1, EepromConcern::question},
                           Row{196, 4, EepromConcern::question}, Row{197, 4, EepromConcern::question},
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

TEST(EepromConcern, AsksEarlierIfSoSetAndNeverLater)
{
    const Capabilities fraba{.eepromBudget = 200, .eepromLimit = 500};
    askFromEepromShare(10);
    EXPECT_EQ(eepromConcern(18, 1, fraba), EepromConcern::none);
    EXPECT_EQ(eepromConcern(19, 1, fraba), EepromConcern::question);
    EXPECT_EQ(eepromConcern(500, 1, fraba), EepromConcern::typed);
    askFromEepromShare(300);
    EXPECT_EQ(eepromConcern(149, 1, fraba), EepromConcern::question);
    askFromEepromShare(75);
    EXPECT_EQ(eepromConcern(148, 1, fraba), EepromConcern::none);
}

class EepromCost : public testing::Test
{
protected:
    EepromCost() { EXPECT_TRUE(bus.open(RingSession::Start::operating)); }
    int of(int segment, const Job &job) const
    {
        return mostEepromWrites(*bus.encoder(DeviceNumber{segment, 0}.node()), job);
    }

    const Catalog catalog = Catalog::builtIn();
    RingSession bus{makeTrainingBus(catalog).link, catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
};

TEST_F(EepromCost, IsTheMostAJobMayWrite)
{
    constexpr int fraba = 1;
    EXPECT_EQ(of(fraba, ReadParameters{{Parameter::steps}}), 0);
    EXPECT_EQ(of(fraba, WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}},
                                        .previous = {},
                                        .initialisePreset = true}),
              3);
    EXPECT_EQ(of(fraba, SetPreset{}), 2); // a used-up preset is programmed again
    EXPECT_EQ(of(fraba, SetPreset{.value = {}, .command = PresetCommand::manufacturer}), 1);
    EXPECT_EQ(of(fraba, SetPreset{.value = 7, .command = PresetCommand::manufacturer}), 2);
    EXPECT_EQ(of(fraba, ResetToDefault{}), 2); // it may be in a changed cam program
    EXPECT_EQ(of(2, ResetToDefault{}), 1);
    EXPECT_EQ(of(fraba, ReadCams{{1, 2, 3}, {}}), 4);
    EXPECT_EQ(of(fraba, SendWords{{0x020000FF, 0x80000000, 0}}), 1);
    EXPECT_EQ(of(2, SwitchMode{}), 0);
}

// As the simulated encoder counts: a program that was changed is stored when it is left.
TEST_F(EepromCost, OfCamsIsThatOfTheProgramsThatAreLeft)
{
    constexpr int fraba = 1;
    const auto isIn = [&](std::int64_t startUpMode) {
        bus.encoder("1.0"_ring)->tell(Parameter::startUpMode, startUpMode);
        bus.advance(std::chrono::milliseconds(50));
    };
    const WriteCams third{{CamProgram{.number = 3}}, true, {}};
    isIn(1); // position mode
    EXPECT_EQ(of(fraba, third), 1);
    isIn(5); // cam program 3
    EXPECT_EQ(of(fraba, third), 1);
    isIn(6);
    EXPECT_EQ(of(fraba, third), 2) << "and program 4, which may have been changed";
}

// No kind of job is left out: new ones state their highest cost here.
TEST_F(EepromCost, IsStatedForEachKindOfJob)
{
    const std::vector<std::pair<Job, int>> all{
        {ReadParameters{{Parameter::steps}}, 0},
        {WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, 1},
        {SetPreset{}, 2},
        {SendWords{{0x020000FF}}, 1},
        {EndParameterization{{{Parameter::steps, 255}, {Parameter::revolutions, 1}}}, 2},
        {SwitchMode{}, 1},
        {ResetToDefault{}, 2},
        {ReadCams{{1, 2}, {}}, 3},
        {WriteCams{{CamProgram{.number = 3}}, true, {}}, 2},
        {StoreParameters{}, 1}};
    ASSERT_EQ(all.size(), std::variant_size_v<Job>);
    for (std::size_t kind = 0; kind < all.size(); ++kind) {
        EXPECT_EQ(all[kind].first.index(), kind);
        EXPECT_EQ(of(1, all[kind].first), all[kind].second) << kind;
    }
}

struct WordRow
{
    Word word;
    int baumer;
    int fraba; // the mode not known
    int rod;
};

TEST_F(EepromCost, OfAWordByHand)
{
    bus.advance(1);
    for (const WordRow &row : {
             WordRow{0x00000000, 0, 0, 0}, // normal running
             WordRow{0x80000000, 0, 0, 0}, // run
             WordRow{0x020000FF, 1, 1, 0}, // parameter 1 = 255
             WordRow{0x0E000000, 1, 1, 0}, // set to default
             WordRow{0x40000000, 0, 1, 0}, // initialise the preset: stored by FRABA
             WordRow{0x60000000, 0, 1, 0}, // FRABA preset
             WordRow{0x20400001, 0, 0, 0}, // velocity on
             WordRow{0x20210001, 0, 0, 0}, // read-out
             WordRow{0x20800000, 0, 1, 0}, // position mode: leaves a cam program, perhaps
             WordRow{0x42000005, 0, 1, 0}, // LA-66 write, the service bit still 0
             WordRow{0xC2000005, 0, 0, 1}, // LA-66: measuring length
             WordRow{0x82000000, 0, 0, 0}, // LA-66: reads it
         }) {
        const auto cost = [&](int segment) {
            return mostEepromWrites(*bus.encoder(DeviceNumber{segment, 0}.node()), row.word);
        };
        EXPECT_EQ(cost(2), row.baumer) << std::hex << row.word;
        EXPECT_EQ(cost(5), row.rod) << std::hex << row.word;
        EXPECT_EQ(cost(1), row.fraba) << std::hex << row.word;
    }
    bus.encoder("1.0"_ring)->tell(Parameter::startUpMode, 1);
    bus.advance(10);
    ASSERT_EQ(bus.encoder("1.0"_ring)->latest().mode, Mode::position);
    EXPECT_EQ(mostEepromWrites(*bus.encoder("1.0"_ring), Word{0x20800001}), 0);
    EXPECT_EQ(of(1, SendWords{{0x20800001, 0x46000015, 0x80000000, 0x20800000}}), 2); // the second leaves it
}

// An unnamed K3 may be a FRABA, so no word costs less.
TEST_F(EepromCost, OfAnUnnamedK3IsThatOfAFraba)
{
    constexpr Place unnamed = "1.0"_ring;
    ASSERT_TRUE(bus.name(unnamed, QStringLiteral("generic-k3")));
    EXPECT_EQ(of(1, SetPreset{}), 1);
    EXPECT_EQ(of(1, SetPreset{.value = 1000}), 2);
    const WriteParameters write{
        .values = {{Parameter::preset, 1000}}, .previous = {}, .initialisePreset = true};
    EXPECT_EQ(of(1, write), 2);
    EXPECT_EQ(mostEepromWrites(*bus.encoder(unnamed), Word{0x4000'0000}), 1);
    const std::vector<Known> inPositionMode{{Parameter::startUpMode, 1, Evidence::told, {}}};
    const DeviceDescription &device = bus.encoder(unnamed)->device();
    for (const Job &job : {Job(SetPreset{.value = 1000}), Job(write)})
        EXPECT_EQ(eepromWritesOf(*plannedSteps(device, job, {.known = inPositionMode}), device), 2);
    const DeviceDescription &baumer = bus.encoder("2.0"_ring)->device();
    EXPECT_EQ(of(2, SetPreset{.value = 1000}), 1);
    EXPECT_EQ(eepromWritesOf(*plannedSteps(baumer, write), baumer), 1);
}

TEST_F(EepromCost, OfWritingBackWhatWasBefore)
{
    const auto step = [](StepKind kind, Word out) {
        return Step{.effect = effectOf(kind, out), .kind = kind, .out = out};
    };
    Progress progress{.index = 2,
                      .steps = {step(StepKind::readOut, 0x20210001), step(StepKind::parameter, 0x020000FF),
                                step(StepKind::parameter, 0x04000001), step(StepKind::parameter, 0x06000003)},
                      .confirmed = {}};
    EXPECT_EQ(mostWritesToRestore(*bus.encoder("2.0"_ring), progress), 2); // including the one under way
    progress.index = 4;
    EXPECT_EQ(mostWritesToRestore(*bus.encoder("2.0"_ring), progress), 3);
    EXPECT_EQ(mostWritesToRestore(*bus.encoder("2.0"_ring), Progress{}), 0);
    progress.steps = {step(StepKind::switchMode, 0x20800001), step(StepKind::camParameter, 0x46000015)};
    EXPECT_EQ(mostWritesToRestore(*bus.encoder("2.0"_ring), progress), 1);
}

TEST_F(EepromCost, SaysWhoseWritesAndByWhat)
{
    const EepromCount count{.writes = 12,
                            .perhaps = 4,
                            .since = QDateTime(QDate(2026, 3, 1), QTime(12, 0)),
                            .by = CountedBy::serialNumber,
                            .serialNumber = QStringLiteral("4711")};
    EXPECT_EQ(eepromCountText(count),
              QStringLiteral(
                  "EEPROM writes by this program since 1 Mar 2026: 12 (and perhaps 4 more, which it began "
                  "and did not see the end of), counted by the serial number 4711 read from the encoder."));
    EXPECT_EQ(eepromCountBrief(count), QStringLiteral("12-16 writes by Codewheel since 1 Mar 2026"));
    EXPECT_EQ(eepromCountBrief({.writes = 3}), QStringLiteral("3 writes by Codewheel"));
    EXPECT_EQ(eepromCountBrief({.writes = 1}), QStringLiteral("1 write by Codewheel"));
    EXPECT_EQ(eepromCountBrief({.writes = 0, .by = CountedBy::place}),
              QStringLiteral("0 writes by Codewheel, S/N?"));
}

} // namespace
} // namespace codewheel
