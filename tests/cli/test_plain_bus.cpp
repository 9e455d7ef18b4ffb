// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the command line does not know.
#include "cli/bus/bus_access.h"
#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/support/plain_bus.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class CliPlainBus : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<test::PlainKind>()); }

    CliRun run(const QString &line)
    {
        QStringList words = line.split(u' ');
        const Subcommand &command = *commandNamed(words.takeFirst());
        const auto arguments = parseArguments(words, optionsOf(command), {});
        EXPECT_TRUE(arguments);
        return runWith({}, [&](const Terminal &terminal) {
            BusAccess access(bus, QStringLiteral("plain"));
            return runOn(command, *arguments, catalog, {&access}, terminal);
        });
    }

    const Catalog catalog = Catalog::builtIn();
    test::PlainBus bus{catalog};
};

TEST_F(CliPlainBus, MonitorShowsItsPositions)
{
    const CliRun shown = run(QStringLiteral("monitor n:2 --for 1 --every 500"));
    EXPECT_EQ(shown.exit, 0) << shown.err;
    EXPECT_THAT(shown.out, HasSubstr("      0.0  000003E9      1001"));
    EXPECT_THAT(shown.out, HasSubstr("   1000.0  000007D1      2001"));
    const QJsonObject json = run(QStringLiteral("monitor Plain/n:2 --for 1 --every 500 --json")).json();
    EXPECT_EQ(json[u"busName"], QStringLiteral("Plain"));
    EXPECT_EQ(json[u"bus"], 9);
    EXPECT_EQ(json[u"place"], QStringLiteral("n:2"));
    EXPECT_EQ(json[u"samples"].toArray().size(), 3);
}

TEST_F(CliPlainBus, WhatIsNoEncoderOrNotThereIsRefused)
{
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor n:3 --json"))), "noEncoder");
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor n:4 --json"))), "unknownDevice");
    EXPECT_EQ(errorKey(run(QStringLiteral("monitor 1.0 --json"))), "placeOnBus");
    EXPECT_EQ(run(QStringLiteral("read n:1")).exit, 1) << "it cannot be read";
}

TEST_F(CliPlainBus, ScanTellsAndKeepsWhatStandsThere)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("plain.codewheel"));
    const CliRun scan = run(QStringLiteral("scan --save ") + file);
    EXPECT_EQ(scan.exit, 0) << scan.err;
    EXPECT_THAT(scan.out, HasSubstr("n:3          -        Lamp\n"));
    const Project project = *loadProject(file);
    ASSERT_EQ(devicesOn(project, test::plainId).size(), 3U);
    EXPECT_EQ(project.devices[1].participant.deviceKey, QStringLiteral("fraba-ocd-ib-k1"));
    EXPECT_EQ(run(QStringLiteral("monitor n:1 --for 1 --project ") + file).exit, 0);
}

} // namespace
} // namespace codewheel
