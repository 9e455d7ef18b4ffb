// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/call/command_line.h"
#include "cli/commands.h"
#include "tests/cli/cli_run.h"
#include "tests/kinds/plain/plain_bus.h"

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

} // namespace codewheel::test
