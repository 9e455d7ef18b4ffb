// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/doctor/made_computer.h"
#include "tests/support/pty_pair.h"

#include <QProcess>

namespace codewheel {
namespace {

TEST(Computer, KnowsWhichProgramHasAPortOpen)
{
    const PtyPair pty;
    QProcess other;
    other.start(
        QStringLiteral(CODEWHEEL_PYTHON),
        {QStringLiteral("-c"),
         QStringLiteral("import os,sys; os.open(sys.argv[1], os.O_RDWR); print('open', flush=True); input()"),
         pty.path()});
    ASSERT_TRUE(other.waitForReadyRead(20'000)) << other.readAllStandardError().toStdString();
    const auto holders = Computer().holdersOf(pty.path());
    other.closeWriteChannel();
    EXPECT_TRUE(other.waitForFinished(20'000));
    ASSERT_EQ(holders.size(), 2U) << "the test itself holds the near end";
    const Process &found = holders[holders[0].isOurs ? 1 : 0];
    EXPECT_TRUE(found.name.startsWith(u"python")) << found.name.toStdString();
    EXPECT_TRUE(holders[holders[0].isOurs ? 0 : 1].isOurs);
}

TEST(Computer, FindsTheHolderOfAPortByAnyOfItsNames)
{
    MadeComputer made;
    made.file(QStringLiteral("/dev/ttyUSB0"));
    made.link(QStringLiteral("/dev/serial/by-id/usb-FTDI"), "../../ttyUSB0");
    made.process(4711, "minicom");
    made.link(QStringLiteral("/proc/4711/fd/3"), "/dev/ttyUSB0");
    made.process(4712, "bash");
    made.link(QStringLiteral("/proc/4712/fd/3"), "/dev/ttyUSB1");
    const auto holders = made.computer().holdersOf(QStringLiteral("/dev/serial/by-id/usb-FTDI"));
    ASSERT_EQ(holders.size(), 1U);
    EXPECT_EQ(holders[0], (Process{4711, QStringLiteral("minicom")}));
}

// Their bytes would be the same text.
TEST(Computer, NamesThatAreNotUtf8AreNotTakenForEachOther)
{
    MadeComputer made;
    made.process(4711, "\xff\xfe");
    made.link(QStringLiteral("/proc/4711/fd/3"), "/dev/tty\xff");
    const Computer computer = made.computer();
    EXPECT_TRUE(computer.holdersOf(QFile::decodeName("/dev/tty\xfe")).empty());
    EXPECT_TRUE(computer.holdersOf(QFile::decodeName("/dev/tty\xff")).empty()) << "no text leads to it";
    EXPECT_FALSE(computer.runs(QString::fromLocal8Bit("\xfe\xff")));
}

TEST(Computer, NamesOfProcessesMayHaveAnythingInThem)
{
    MadeComputer made;
    made.process(4711, "a (b) 7 c) S");
    made.link(QStringLiteral("/proc/4711/fd/3"), "/dev/ttyUSB0");
    const auto holders = made.computer().holdersOf(QStringLiteral("/dev/ttyUSB0"));
    ASSERT_EQ(holders.size(), 1U);
    EXPECT_EQ(holders[0].name, QStringLiteral("a (b) 7 c) S"));
}

// However many ports are asked for.
TEST(Computer, LooksAtProcessesOnce)
{
    MadeComputer made;
    const Computer computer = made.computer();
    EXPECT_TRUE(computer.holdersOf(QStringLiteral("/dev/ttyUSB0")).empty());
    made.process(4711, "minicom");
    made.link(QStringLiteral("/proc/4711/fd/3"), "/dev/ttyUSB0");
    EXPECT_TRUE(computer.holdersOf(QStringLiteral("/dev/ttyUSB0")).empty());
    EXPECT_EQ(made.computer().holdersOf(QStringLiteral("/dev/ttyUSB0")).size(), 1U);
}

TEST(Computer, ALongFileIsReadToItsEnd)
{
    MadeComputer made;
    made.file(QStringLiteral("/etc/group"), QByteArray(100'000, 'x') + "\ndialout:x:20:max");
    EXPECT_TRUE(made.computer().contents(QStringLiteral("/etc/group")).endsWith(":max"));
}

TEST(Computer, WhatIsNotThereIsEmpty)
{
    const Computer computer(QStringLiteral("/nowhere"));
    EXPECT_FALSE(computer.has(QStringLiteral("/proc")));
    EXPECT_TRUE(computer.contents(QStringLiteral("/proc/1/comm")).isEmpty());
    EXPECT_TRUE(computer.folders(QStringLiteral("/sys")).isEmpty());
    EXPECT_TRUE(computer.holdersOf(QStringLiteral("/dev/ttyUSB0")).empty());
    EXPECT_FALSE(computer.runs(QString()));
    EXPECT_TRUE(computer.target(QStringLiteral("/proc/self")).isEmpty());
}

} // namespace
} // namespace codewheel
