// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

using testing::Contains;
using testing::ContainsRegex;

std::vector<std::string> namesIn(const QJsonObject &json)
{
    std::vector<std::string> names;
    for (const QJsonValue device : json[u"devices"].toArray())
        names.push_back(device[u"name"].toString().toStdString());
    return names;
}

TEST(CliDevices, ListsWhatTheProgramKnows)
{
    const CliRun run = runLine(QStringLiteral("devices"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, ContainsRegex("fraba-ocd-ib +K3 +0237h +yes +FRABA OCD-IB K3\n"));
    EXPECT_THAT(run.out, ContainsRegex("baumer-gxp6w +K3 +0237h +no +Baumer GXP6W K3\n"));
    const std::vector<std::string> names = namesIn(runLine(QStringLiteral("devices --json")).json());
    EXPECT_THAT(names, Contains("fraba-ocd-ib"));
    EXPECT_THAT(names, Contains("baumer-gxp6w"));
}

TEST(CliDevices, TellsTheParametersOfOne)
{
    const CliRun run = runLine(QStringLiteral("devices fraba-ocd-ib"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("cw (3), ccw (4)"));
    EXPECT_THAT(run.out, HasSubstr("1..33554431"));
    EXPECT_THAT(run.out, HasSubstr("\nError 1: wrong parameter data\n"));
    EXPECT_THAT(run.out, HasSubstr("EEPROM writes: about 200, nothing is guaranteed past 500"));
    EXPECT_THAT(runLine(QStringLiteral("devices baumer-gxp6w")).out,
                HasSubstr("EEPROM writes: not stated in the manual"));
}

TEST(CliDevices, OfAnEncoderThatOnlyTellsItsPositionThereIsNothingToList)
{
    const CliRun run = runLine(QStringLiteral("devices fraba-ocd-ib-k1"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("FRABA OCD-IB K1 (FRABA UME OCD IB, version 11/03)\nPosition only:"));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("EEPROM")));
    EXPECT_THAT(run.out, testing::Not(HasSubstr("parameter  number")));
}

TEST(CliDevices, TellsProgramsNumbersRangesAndChoices)
{
    const QJsonObject json = runLine(QStringLiteral("devices fraba-ocd-ib --json")).json();
    EXPECT_EQ(json[u"eepromBudget"], 200);
    const QJsonObject direction = json[u"parameters"][2].toObject();
    EXPECT_EQ(direction[u"parameter"], QStringLiteral("direction"));
    EXPECT_EQ(direction[u"number"], 3);
    EXPECT_EQ(direction[u"readOut"], 3);
    EXPECT_EQ(direction[u"factory"], 3);
    EXPECT_EQ(direction[u"choices"][1][u"choice"], QStringLiteral("ccw"));
    EXPECT_TRUE(runLine(QStringLiteral("devices baumer-gxp6w --json")).json()[u"eepromBudget"].isNull());
}

TEST(CliDevices, WhatIsNotKnownIsNull)
{
    const QJsonArray devices = runLine(QStringLiteral("devices --json")).json()[u"devices"].toArray();
    for (const QJsonValue device : devices) {
        const bool onBus =
            device[u"profile"] != QStringLiteral("ESC") && device[u"profile"] != QStringLiteral("CiA-406");
        EXPECT_EQ(device[u"idCode"].isDouble(), onBus) << device[u"name"].toString().toStdString();
        EXPECT_EQ(device[u"deviceCode"].isDouble(), onBus) << device[u"name"].toString().toStdString();
        EXPECT_NE(device[u"idCode"], 0);
    }
    const QJsonObject fraba =
        runLine(QStringLiteral("devices --label OCD-IBA1B-1213-C100-PRI --json")).json();
    EXPECT_EQ(fraba[u"devices"][0][u"turns"], 4'096);
    const QJsonObject kuebler = runLine(QStringLiteral("devices --label 8.5882.xx1x.1001 --json")).json();
    EXPECT_TRUE(kuebler[u"devices"][0][u"deviceCode"].isNull());
    const QJsonObject rod = runLine(QStringLiteral("devices --check /nowhere.json --json")).json();
    EXPECT_TRUE(rod[u"line"].isNull());
}

TEST(CliDevices, AnUnknownNameIsToldWithTheNamesThereAre)
{
    const CliRun run = runLine(QStringLiteral("devices fraba --json"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "unknownDeviceName");
    EXPECT_THAT(run.err, HasSubstr("fraba-ocd-ib"));
}

} // namespace
} // namespace codewheel
