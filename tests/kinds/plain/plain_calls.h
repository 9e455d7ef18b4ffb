// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "project/bus_plans.h"
#include "project/project_file.h"
#include "tests/cli/cli_run.h"
#include "tests/kinds/plain/plain_bus.h"

#include <QTemporaryDir>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::test {

// A call on a bus of the tests' own kind; its EEPROM writes are counted in this ledger, if there is one.
inline CliRun callOn(PlainBus &bus, const QString &line, const QString &ledger = {})
{
    QStringList words = line.split(u' ');
    const Subcommand &command = *commandNamed(words.takeFirst());
    if (!ledger.isEmpty())
        words << QStringLiteral("--ledger") << ledger;
    const auto arguments = parseArguments(words, optionsOf(command), {});
    EXPECT_TRUE(arguments);
    return runWith({}, [&](const Terminal &terminal) {
        BusAccess access(bus, QStringLiteral("plain"));
        if (command.needsBus && !ledger.isEmpty())
            access.keepLedger(ledger);
        return runOn(command, *arguments, bus.catalog(), {&access}, terminal);
    });
}

// Calls on such a bus, in Operate, with a project file for it.
class PlainCalls : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<PlainKind>()); }
    explicit PlainCalls(const std::vector<PlainStation> &stations = plainStations())
        : bus(catalog, stations)
    {
        bus.setOperate(true);
    }

    CliRun run(const QString &line) { return callOn(bus, line); }
    // In the file.
    void want(Place place, const ParameterValues &values)
    {
        EXPECT_EQ(run(QStringLiteral("scan --save ") + file).exit, 0);
        Project project = *loadProject(file);
        std::ranges::find(project.devices, place, &ProjectDevice::place)->wanted = values;
        EXPECT_TRUE(saveProject(project, file));
    }

    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("yard.codewheel"));
    const Catalog catalog = Catalog::builtIn();
    PlainBus bus;
};

} // namespace codewheel::test
