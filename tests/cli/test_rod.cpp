// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The TR LA-66 at 5.0: 500 mm, 50 000 steps, the magnet at 125 mm.
namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CliRod, ReadsWhatHasAService)
{
    EXPECT_EQ(runLine(QStringLiteral("read 5.0 measuring-length error-status")).out,
              "measuring-length  = 50000 steps\n"
              "error-status      = no-error (0)\n");
}

TEST(CliRod, WhatStandsOnTheLabelIsNeitherReadNorWritten)
{
    for (const char *line : {"read 5.0 rod-length --json", "write 5.0 rod-length=500000 --yes --json"}) {
        const CliRun run = runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 2) << line;
        EXPECT_EQ(errorKey(run), "parameterOnLabel") << line;
        EXPECT_THAT(run.err, HasSubstr("Rod length is only on the label of the TR LA-66: it is neither "
                                       "read nor written over the bus. There are: "))
            << line;
    }
}

TEST(CliRod, IsWrittenByServicesAndReadBack)
{
    const CliRun run = runLine(QStringLiteral("write 5.0 measuring-length=5000 --all --yes --trace --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(rowsOf(run.json()),
                ElementsAre("00000000 000030D4", "42001388 000030D4", "C2001388 000030D4",
                            "C2001388 C2001388", "42001388 C2001388", "42001388 000004E2",
                            "02000000 000004E2", "82000000 000004E2", "82000000 82001388",
                            "02000000 82001388", "02000000 000004E2", "00000000 000004E2"));
    EXPECT_EQ(run.json()[u"eepromWrites"], 1);
    EXPECT_EQ(run.json()[u"plan"][0][u"word"], QStringLiteral("C2001388"));
    EXPECT_EQ(run.json()[u"written"][0][u"evidence"], QStringLiteral("read"));
    EXPECT_THAT(runLine(QStringLiteral("write 5.0 measuring-length=5000 --yes")).out,
                HasSubstr("Position before: 12500 (125.00 mm)\nPosition after:  1250 (125.0 mm)\n"));
}

TEST(CliRod, WhatItHasAlreadyIsNotWritten)
{
    const CliRun run = runLine(QStringLiteral("write 5.0 measuring-length=50000 --yes --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.json()[u"eepromWrites"], 0);
}

TEST(CliRod, ThePositionIsSetToTheValueGiven)
{
    const QJsonObject json = runLine(QStringLiteral("preset 5.0 1000 --json")).json();
    EXPECT_EQ(json[u"positionBefore"], 12500);
    EXPECT_EQ(json[u"positionAfter"], 1000);
    EXPECT_EQ(json[u"eepromWrites"], 1);
    EXPECT_EQ(runLine(QStringLiteral("preset 5.0 1000")).out, "Position before: 12500 (125.00 mm)\n"
                                                              "Position after:  1000 (10.00 mm)\n"
                                                              "EEPROM writes:   1\n");
    const CliRun without = runLine(QStringLiteral("preset 5.0"));
    EXPECT_EQ(errorKey(runLine(QStringLiteral("preset 5.0 --json"))), "presetNeedsValue");
    EXPECT_EQ(without.exit, 2);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("preset 5.0 16777216 --json"))), "valueOutOfRange");
}

TEST(CliRod, WithoutItsMagnetThePositionIsNotSetAndAWriteTellsTheState)
{
    SharedBus shared;
    shared.controls().setFault(TrainingFault::magnetLost, NodeId("5.0"), 1);
    const CliRun preset = shared.runLine(QStringLiteral("preset 5.0 1000"));
    EXPECT_EQ(preset.exit, 1);
    EXPECT_THAT(preset.err, HasSubstr("The magnet is outside the measuring range"));
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_THAT(shared.runLine(QStringLiteral("write 5.0 direction=decreasing --yes")).out,
                HasSubstr("The encoder was left in error: it shows the last position it knew.\n"));
}

TEST(CliRod, IsWatchedInStepsAndMillimetres)
{
    EXPECT_THAT(runLine(QStringLiteral("monitor 5.0 --for 1")).out,
                HasSubstr("Running, position 12500 (125.00 mm)\n"));
    const QJsonObject json = runLine(QStringLiteral("monitor 5.0 --for 1 --json")).json();
    EXPECT_EQ(json[u"samples"][0][u"millimetres"], 125);
}

TEST(CliRod, WithoutTheLengthOfTheRodThereAreNoMillimetres)
{
    SharedBus shared;
    shared.bus().encoder("5.0"_ring)->tell(Parameter::rodLength, std::nullopt);
    EXPECT_THAT(shared.runLine(QStringLiteral("monitor 5.0 --for 1")).out,
                HasSubstr("Running, position 12500\n"));
    const QJsonObject json = shared.runLine(QStringLiteral("monitor 5.0 --for 1 --json")).json();
    EXPECT_TRUE(json[u"samples"][0][u"millimetres"].isNull());
}

TEST(CliRod, ARefusedWordEndsTheSequence)
{
    const CliRun run = runLine(QStringLiteral("words 5.0 42000000 C2000000 42000000 00000000"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("Refused: Service 2 measuring length in steps: write 0"));
    EXPECT_THAT(run.err, HasSubstr("refused service 2 (IN E2000000)"));
}

} // namespace
} // namespace codewheel
