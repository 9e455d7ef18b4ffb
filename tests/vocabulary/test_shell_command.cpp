// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/shell_command.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(ShellCommand, PlainWordsStayAsTheyAre)
{
    EXPECT_EQ(
        shellCommand(QStringLiteral("ls %1 %2"), {QStringLiteral("/dev/ttyUSB0"), QStringLiteral("a-b.c:1")}),
        QStringLiteral("ls /dev/ttyUSB0 a-b.c:1"));
}

TEST(ShellCommand, WhatSomebodyTypedIsOneWordToTheShell)
{
    const std::pair<const char *, const char *> rows[] = {
        {"/dev/my port", "ls '/dev/my port'"},
        {"a;reboot", "ls 'a;reboot'"},
        {"$(reboot)", "ls '$(reboot)'"},
        {"it's", "ls 'it'\\''s'"},
        {"", "ls ''"},
    };
    for (const auto &[typed, command] : rows)
        EXPECT_EQ(shellCommand(QStringLiteral("ls %1"), {QString::fromUtf8(typed)}),
                  QString::fromUtf8(command));
}

TEST(ShellCommand, WhatCannotBeShownOrIsAnOptionMakesNoCommand)
{
    for (const char *typed : {"a\nreboot", "a\x1b[2K", "-rf", "--help"})
        EXPECT_EQ(shellCommand(QStringLiteral("ls %1"), {QString::fromUtf8(typed)}), QString()) << typed;
}

} // namespace
} // namespace codewheel
