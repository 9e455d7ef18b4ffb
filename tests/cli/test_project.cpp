// SPDX-License-Identifier: GPL-3.0-or-later
// A project names the encoders of a call, and a scan makes one.
#include "catalog/catalog.h"
#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "cli/kinds/interbus/ring_access.h"
#include "kinds/interbus/ring/ring_session.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace codewheel {
namespace {

using testing::HasSubstr;

const Place first = "1.0"_ring;
const Place second = "2.0"_ring;

ProjectDevice encoder(Place number, const char *key, const char *station)
{
    ProjectDevice device;
    device.participant = RingDevice{number.node, 0x0237, 2, 2, QString::fromLatin1(key)};
    device.station = QString::fromLatin1(station);
    return device;
}

// Two K3 encoders whose make the bus does not tell.
class CliProject : public testing::Test
{
protected:
    CliProject()
        : m_bus(std::make_unique<ScriptedLink>(
                    RingStructure{{first.node, 0x0237, 2, 2, {}}, {second.node, 0x0237, 2, 2, {}}}),
                m_catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC))
    {
        EXPECT_TRUE(m_bus.open(RingSession::Start::operating));
        m_project.devices = {encoder(first, "fraba-ocd-ib", "hoist"),
                             encoder(second, "baumer-gxp6w", "trolley")};
    }

    QString file() const { return m_folder.filePath(QStringLiteral("crane.codewheel")); }
    CliRun run(const Subcommand &command, QStringList words)
    {
        EXPECT_TRUE(saveProject(m_project, file()));
        words << QStringLiteral("--project") << file();
        std::istringstream in;
        std::ostringstream out;
        std::ostringstream err;
        const auto arguments = parseArguments(words, optionsOf(command), {});
        EXPECT_TRUE(arguments);
        RingAccess ring(m_bus);
        const int exit = runOn(command, *arguments, m_catalog, {&ring}, Terminal{in, out, err});
        return {exit, out.str(), err.str()};
    }
    QString nameAt(Place number) const { return m_bus.encoder(number)->device().key; }

    const Catalog m_catalog = Catalog::builtIn();
    RingSession m_bus;
    Project m_project;
    QTemporaryDir m_folder;
};

TEST_F(CliProject, NamesTheEncoders)
{
    const CliRun scan = run(scanCommand, {});
    EXPECT_THAT(scan.out, HasSubstr("FRABA OCD-IB K3"));
    EXPECT_THAT(scan.out, HasSubstr("Baumer GXP6W K3"));
    EXPECT_EQ(scan.err, "");
    EXPECT_EQ(nameAt(first), QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(nameAt(second), QStringLiteral("baumer-gxp6w"));
}

TEST_F(CliProject, TellsWhatTheLabelSays)
{
    m_project.devices[1].label = {512, 1024, {}};
    run(scanCommand, {});
    EXPECT_EQ(m_bus.encoder(second)->device().physicalTurns, 512);
    EXPECT_EQ(m_bus.encoder(second)->device().physicalStepsPerTurn, 1024);
}

TEST_F(CliProject, AnEncoderThatIsNamedSoAlreadyKeepsWhatIsKnown)
{
    run(scanCommand, {});
    m_bus.encoder(first)->tell(Parameter::steps, 255);
    run(scanCommand, {});
    EXPECT_TRUE(m_bus.encoder(first)->known(Parameter::steps));
}

TEST_F(CliProject, PlaceMayBeAStation)
{
    const CliRun words =
        run(wordsCommand, {QStringLiteral("trolley"), QStringLiteral("0"), QStringLiteral("--json")});
    EXPECT_EQ(words.json()[u"place"], QStringLiteral("2.0"));
    EXPECT_EQ(run(wordsCommand, {QStringLiteral("1.0"), QStringLiteral("0"), QStringLiteral("--json")})
                  .json()[u"place"],
              QStringLiteral("1.0"));
}

TEST_F(CliProject, AStationThatIsNotThereOrTwiceIsBadInput)
{
    EXPECT_EQ(
        errorKey(run(wordsCommand, {QStringLiteral("cabin"), QStringLiteral("0"), QStringLiteral("--json")})),
        "unknownStation");
    m_project.devices[1].station = QStringLiteral("hoist");
    const CliRun twice = run(wordsCommand, {QStringLiteral("hoist"), QStringLiteral("0")});
    EXPECT_EQ(twice.exit, 2);
    EXPECT_THAT(twice.err,
                HasSubstr("several devices at the station \"hoist\". Give one of these: 1.0, 2.0."));
}

TEST_F(CliProject, NothingIsSentToAStationWhereTheBusDiffers)
{
    m_project.devices.insert(m_project.devices.begin(), encoder(first, "", "cabin"));
    m_project.devices[0].participant = RingDevice{first.node, 0x81BE, 1, 0, {}};
    m_project.devices[1].participant.number = NodeId("2.0");
    m_project.devices[2].participant.number = NodeId("3.0");
    const CliRun hoist = run(wordsCommand, {QStringLiteral("hoist"), QStringLiteral("020000FF")});
    EXPECT_EQ(hoist.exit, 1);
    EXPECT_THAT(hoist.err, HasSubstr("\"hoist\" may be elsewhere"));
    const CliRun other = run(wordsCommand, {QStringLiteral("1.0"), QStringLiteral("020000FF")});
    EXPECT_EQ(other.exit, 1);
    EXPECT_THAT(other.err, HasSubstr("1.0: configured is 81BEh, found was 0237h."));
    EXPECT_EQ(m_bus.latest().cycle, 0u) << "something was sent";
}

TEST_F(CliProject, ADeviceWithoutDescriptionIsLeftAsItIs)
{
    m_project.devices[0].participant.deviceKey = QStringLiteral("my-encoder");
    const CliRun scan = run(scanCommand, {});
    EXPECT_EQ(scan.exit, 0);
    EXPECT_THAT(scan.err, HasSubstr("1.0 is not treated as \"my-encoder\""));
    EXPECT_EQ(nameAt(first), QStringLiteral("generic-k3"));
}

TEST_F(CliProject, AScanIsSavedAsAProject)
{
    const QString found = m_folder.filePath(QStringLiteral("found.codewheel"));
    const CliRun scan = run(scanCommand, {QStringLiteral("--save"), found, QStringLiteral("--json")});
    EXPECT_EQ(scan.exit, 0);
    EXPECT_EQ(scan.json()[u"saved"], found);
    EXPECT_EQ(loadProject(found), m_project) << "what the project knows is taken along";
}

TEST_F(CliProject, AScanReplacesNoFileUnasked)
{
    const QString found = m_folder.filePath(QStringLiteral("found.codewheel"));
    ASSERT_TRUE(saveProject(Project(), found));
    const CliRun scan = run(scanCommand, {QStringLiteral("--save"), found});
    EXPECT_EQ(scan.exit, 2);
    EXPECT_THAT(scan.err, HasSubstr("is there already. Nothing was saved."));
    EXPECT_EQ(loadProject(found), Project());
    EXPECT_EQ(run(scanCommand, {QStringLiteral("--save"), found, QStringLiteral("--yes")}).exit, 0);
    EXPECT_EQ(loadProject(found), m_project);
    EXPECT_EQ(loadProject(backupPath(found)), Project());
}

TEST_F(CliProject, AScanThatCannotBeSavedIsToldAfterIt)
{
    const CliRun scan =
        run(scanCommand, {QStringLiteral("--save"), m_folder.filePath(QStringLiteral("no/found.codewheel"))});
    EXPECT_EQ(scan.exit, 2);
    EXPECT_THAT(scan.out, HasSubstr("0237h"));
    EXPECT_THAT(scan.err, HasSubstr("cannot be written"));
}

TEST_F(CliProject, ABrokenProjectStopsTheCall)
{
    QFile broken(file());
    ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
    broken.write("{}");
    broken.close();
    const CliRun scan = runLine(QStringLiteral("scan --json --project ") + file());
    EXPECT_EQ(scan.exit, 2);
    EXPECT_EQ(errorKey(scan), "projectFileBroken");
}

} // namespace
} // namespace codewheel
