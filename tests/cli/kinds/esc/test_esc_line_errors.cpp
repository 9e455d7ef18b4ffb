// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "project/project_file.h"
#include "tests/cli/kinds/esc/shared_line.h"
#include "tests/support/plans.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

struct BadLineCall
{
    const char *line;
    const char *key;
    int exit;
};

// An echo with one wrong bit in every byte.
TEST(CliLineStrayBytes, AreToldWithTheirNumberAndWhatTheyCanMean)
{
    for (const char *called : {"read 05 steps", "preset 05 5 --yes", "monitor 05 --for 1"}) {
        SharedLine line;
        line.simulated().setFaults({.corrupted = 1'000, .echo = true});
        const CliRun run = line.runLine(QString::fromLatin1(called) + QStringLiteral(" --json"));
        EXPECT_EQ(run.exit, 1) << called;
        EXPECT_EQ(errorKey(run), "noAnswerAmongBytes") << called;
        const QJsonArray arguments = run.json()[u"error"][u"arguments"].toArray();
        ASSERT_EQ(arguments.size(), 3);
        EXPECT_GT(arguments[2].toInteger(), 10) << called;
        EXPECT_THAT(run.err, HasSubstr("bytes that are no answers: "));
        EXPECT_THAT(run.err, HasSubstr("another baud rate"));
        EXPECT_THAT(run.err, HasSubstr("another protocol"));
    }
    SharedLine line;
    line.simulated().setFaults({.corrupted = 1'000, .echo = true});
    EXPECT_THAT(line.runLine(QStringLiteral("scan --last 02")).out,
                HasSubstr("Bytes come that are no answers: "));
    EXPECT_THAT(line.runLine(QStringLiteral("terminal 05P")).err,
                HasSubstr("Bytes come that are no answers: "));
}

class CliLineErrors : public testing::TestWithParam<BadLineCall>
{};

TEST_P(CliLineErrors, AreSaidInASentence)
{
    const CliRun run = runLine(QString::fromLatin1(GetParam().line) + QStringLiteral(" --json"));
    EXPECT_EQ(run.exit, GetParam().exit);
    EXPECT_EQ(errorKey(run), GetParam().key);
    EXPECT_NE(run.err, "");
}

INSTANTIATE_TEST_SUITE_P(
    Calls, CliLineErrors,
    testing::Values(
        BadLineCall{"read 00", "encoderNotAlone", 1}, BadLineCall{"read 20", "lineAddressWrong", 2},
        BadLineCall{"read 32", "lineAddressWrong", 2}, BadLineCall{"read esc:5", "lineAddressWrong", 2},
        BadLineCall{"read FF", "lineAddressWrong", 2}, BadLineCall{"read 07", "encoderSilent", 1},
        BadLineCall{"monitor 1F", "encoderSilent", 1}, BadLineCall{"preset 07 5", "encoderSilent", 1},
        BadLineCall{"read 1.0 --link esc:training", "placeOnBus", 2},
        BadLineCall{"read hoist --link esc:training", "lineAddressWrong", 2},
        BadLineCall{"read 05 coding", "parameterNotSupported", 2},
        BadLineCall{"read 05 --link esc:training,baud=9600", "encoderSilent", 1}));

INSTANTIATE_TEST_SUITE_P(
    CommandsOfTheBus, CliLineErrors,
    testing::Values(
        BadLineCall{"words 05 020000FF", "notOnSerialLine", 2},
        BadLineCall{"velocity 05 on", "notOnSerialLine", 2},
        BadLineCall{"reset 05 --yes", "notOnSerialLine", 2},
        BadLineCall{"cams 05 read", "notOnSerialLine", 2},
        BadLineCall{"clone 05 07 --yes", "encoderSilent", 1},
        BadLineCall{"restore 05", "noValuesFromBefore", 1},
        BadLineCall{"master --link esc:training", "notOnSerialLine", 2},
        BadLineCall{"compare " CODEWHEEL_ROOT "/docs/examples/training.codewheel --link esc:training",
                    "projectEmpty", 2},
        BadLineCall{"store " CODEWHEEL_ROOT "/docs/examples/training.codewheel --link esc:training",
                    "projectEmpty", 2},
        BadLineCall{"transfer " CODEWHEEL_ROOT "/docs/examples/training.codewheel --link esc:training",
                    "projectEmpty", 2},
        BadLineCall{"transfer " CODEWHEEL_ROOT "/docs/examples/training.codewheel --link esc:project",
                    "noBuses", 2},
        BadLineCall{"replace 1.0 --project " CODEWHEEL_ROOT
                    "/docs/examples/training.codewheel --link esc:training",
                    "placeOnBus", 2},
        BadLineCall{"scan --link esc:training --fault-plan x.json", "faultPlanOnLine", 2}));

// A project with a ring device and a line device whose stations look like addresses.
class CliLineStations : public testing::Test
{
protected:
    CliLineStations()
    {
        Project project = *loadProject(QStringLiteral(CODEWHEEL_ROOT "/docs/examples/training.codewheel"));
        project.devices.front().station = QStringLiteral("05");
        ProjectDevice encoder;
        encoder.standAt(placeOnLine({0x12}));
        encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs422");
        encoder.station = QStringLiteral("Slewing gear");
        setLinePlan(project, firstLine, {});
        project.devices.push_back(encoder);
        encoder.standAt(placeOnLine({0x03}));
        encoder.station = QStringLiteral("0A");
        project.devices.insert(project.devices.end() - 1, encoder);
        EXPECT_TRUE(saveProject(project, m_file));
    }
    CliRun read(const char *place) const
    {
        return runLine(QStringLiteral("read %1 serial-number --json --project %2")
                           .arg(QString::fromLatin1(place), m_file));
    }

    QTemporaryDir m_folder;
    QString m_file = m_folder.filePath(QStringLiteral("plant.codewheel"));
};

TEST_F(CliLineStations, GoBeforeAddresses)
{
    EXPECT_EQ(read("05").json()[u"place"], QStringLiteral("1.0"));
    EXPECT_EQ(read("esc:05").json()[u"place"], QStringLiteral("esc:05"));
    EXPECT_EQ(read("0A").json()[u"place"], QStringLiteral("esc:03"));
    EXPECT_EQ(read("12").json()[u"place"], QStringLiteral("esc:12"));
}

TEST_F(CliLineStations, OfTheLineAreFoundWithTheirMake)
{
    const QJsonObject json = read("0A").json();
    EXPECT_EQ(json[u"device"], QStringLiteral("kuebler-esc-rs422"));
    EXPECT_EQ(json[u"values"][0][u"value"], 0x12D591);
}

TEST_F(CliLineStations, OfTheRingAreNotOnASerialLine)
{
    EXPECT_EQ(
        errorKey(runLine(QStringLiteral("read 05 --json --link esc:training --project %1").arg(m_file))),
        "stationOnBus");
}

} // namespace
} // namespace codewheel
