// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"

#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> meanings(const char *line)
{
    const QJsonObject json =
        runLine(QStringLiteral("explain %1 --json").arg(QString::fromLatin1(line))).json();
    std::vector<std::string> ids;
    for (const QJsonValue meaning : json[u"meanings"].toArray())
        ids.push_back(meaning[u"id"].toString().toStdString());
    return ids;
}

TEST(CliExplain, TellsWhatAWordMeans)
{
    const CliRun run = runLine(QStringLiteral("explain 020000FF --device fraba-ocd-ib --direction out"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "OUT 020000FF, FRABA OCD-IB K3\n"
                       "  Parameter 1 steps = 255\n");
}

TEST(CliExplain, TellsProgramsIdAndNumbers)
{
    const QJsonObject json =
        runLine(QStringLiteral("explain 0xC20000ff --device fraba-ocd-ib --direction in --json")).json();
    EXPECT_EQ(json[u"word"], QStringLiteral("C20000FF"));
    EXPECT_EQ(json[u"direction"], QStringLiteral("in"));
    EXPECT_EQ(json[u"meanings"][0][u"id"], QStringLiteral("confirmed"));
    EXPECT_EQ(json[u"meanings"][0][u"numbers"][1], 255);
}

TEST(CliExplain, TheCounterpartTellsWhatWasRead)
{
    EXPECT_THAT(meanings("A0002000 --device fraba-ocd-ib --direction in --other 20210001"),
                ElementsAre("readOutValue"));
    EXPECT_THAT(meanings("A0002000 --device fraba-ocd-ib --direction in"),
                testing::Not(ElementsAre("readOutValue")));
}

// FRABA manual 1.1 and 8: 13 bits for the turn and 12 for the turns.
TEST(CliExplain, TheLabelTellsHowManyBitsAPositionHas)
{
    const QString word = QStringLiteral("explain 01FFFFFF --direction in");
    EXPECT_THAT(runLine(word + QStringLiteral(" --device fraba-ocd-ib-k2")).out, HasSubstr("No position"));
    const CliRun run =
        runLine(word + QStringLiteral(" --device fraba-ocd-ib-k2 --label OCD-IBA1B-1213-C100-PRI"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Running, position 33554431"));
    EXPECT_THAT(runLine(QStringLiteral("explain 00001FFF --direction in --device fraba-ocd-ib-k1 "
                                       "--label OCD-IBA1B-0013-C100-PRI"))
                    .out,
                HasSubstr("Running, position 8191"));
    EXPECT_EQ(errorKey(runLine(word + QStringLiteral(" --label OCD-IBA1B-1213-C100-PRI --json"))),
              "missingOption")
        << "the key is that of a K2 and of a K3";
    EXPECT_EQ(errorKey(runLine(word + QStringLiteral(" --label OCD-IBA1B-1213-C100-PRI --device baumer-gxp6w "
                                                     "--json"))),
              "labelOfOther");
    EXPECT_EQ(errorKey(runLine(word + QStringLiteral(" --label OCD-IBA1B-1413-C100-PRI --json"))),
              "labelKeyNotUnderstood");
}

TEST(CliExplain, AValueThatTheEncoderRefusesHasAnIdOfItsOwn)
{
    EXPECT_THAT(meanings("04004E20 --device baumer-gxp6w --direction out"),
                ElementsAre("parameterRequestInvalid"));
    EXPECT_THAT(meanings("10000001 --device fraba-ocd-ib --direction out"),
                ElementsAre("parameterRequestUndefined"));
    EXPECT_THAT(meanings("020000FF --device fraba-ocd-ib --direction out"), ElementsAre("parameterRequest"));
}

TEST(CliExplain, WithoutTheModeAllMeaningsAreGiven)
{
    EXPECT_THAT(meanings("40000000 --device fraba-ocd-ib --direction out"),
                ElementsAre("initialisePreset", "camStart"));
    EXPECT_THAT(meanings("40000000 --device fraba-ocd-ib --direction out --mode cam"),
                ElementsAre("camStart"));
    EXPECT_THAT(meanings("40000000 --device fraba-ocd-ib --direction out --mode position"),
                ElementsAre("initialisePreset"));
    EXPECT_THAT(runLine(QStringLiteral("explain 40000000 --device fraba-ocd-ib --direction out")).out,
                HasSubstr("To narrow it down: --mode"));
}

// It may be a FRABA in any mode.
TEST(CliExplain, WithoutTheMakeTheMeaningsOfCamModeAreGiven)
{
    EXPECT_THAT(meanings("40000000 --device generic-k3 --direction out"),
                ElementsAre("initialisePreset", "camStart"));
    EXPECT_THAT(meanings("60000000 --device generic-k3 --direction out"),
                ElementsAre("manufacturerSpecificOut", "frabaPreset", "camStop"));
    EXPECT_THAT(meanings("20400001 --device generic-k3 --direction out"),
                ElementsAre("manufacturerSpecificOut", "velocityOn", "camConfiguration"));
    EXPECT_THAT(meanings("00003039 --device generic-k3 --direction in"),
                ElementsAre("rawPosition", "velocity", "cams"));
    EXPECT_THAT(meanings("40000000 --device generic-k3 --direction out --mode position"),
                ElementsAre("initialisePreset"));
    EXPECT_THAT(meanings("40000000 --device twk-k3 --direction out"), ElementsAre("initialisePreset"));
    EXPECT_THAT(runLine(QStringLiteral("explain 40000000 --device generic-k3 --direction out")).out,
                HasSubstr("To narrow it down: --device, --mode"));
}

TEST(CliExplain, TheCodingDecidesWhatAPositionIs)
{
    EXPECT_THAT(meanings("01FFFFFF --device baumer-gxp6w --direction in --coding 1"),
                ElementsAre("signedPosition"));
    EXPECT_THAT(meanings("01FFFFFF --device baumer-gxp6w --direction in --coding unsigned-ccw"),
                ElementsAre("position"));
    EXPECT_THAT(meanings("01FFFFFF --device generic-k3 --direction in --coding 5 --mode position"),
                ElementsAre("grayPosition"));
}

struct BadExplain
{
    const char *line;
    const char *key;
    const char *help;
};

class CliExplainBadInput : public testing::TestWithParam<BadExplain>
{};

TEST_P(CliExplainBadInput, IsRefused)
{
    const CliRun run = runLine(QStringLiteral("explain %1 --json").arg(QString::fromLatin1(GetParam().line)));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), GetParam().key);
    EXPECT_THAT(run.err, HasSubstr(GetParam().help));
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CliExplainBadInput,
    testing::Values(
        BadExplain{"020000FF --direction in", "missingOption", "fraba-ocd-ib"},
        BadExplain{"020000FF --device fraba-ocd-ib", "missingOption", "in, out"},
        BadExplain{"020000FF --device fraba --direction in", "unknownDeviceName", "fraba-ocd-ib"},
        BadExplain{"020000FF --device fraba-ocd-ib --direction up", "optionNotAllowed", "in, out"},
        BadExplain{"020000FF --device fraba-ocd-ib --direction in --mode x", "optionNotAllowed",
                   "position, cam, velocity"},
        BadExplain{"020000FF --device fraba-ocd-ib --direction in --coding 3", "oneCodingOnly", "--coding"},
        BadExplain{"020000FF --device baumer-gxp6w --direction in --coding 7", "valueNotAllowed",
                   "signed-cw (1)"},
        BadExplain{"020000FF --device baumer-gxp6w --direction in --other xyz", "notAWord", "\"xyz\""},
        BadExplain{"0020000FF --device baumer-gxp6w --direction in", "notAWord", "8 hexadecimal digits"}));

} // namespace
} // namespace codewheel
