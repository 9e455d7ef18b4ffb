// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/hindrance_of_refusal.h"
#include "doctor/link_hindrances.h"
#include "tests/doctor/made_computer.h"
#include "tests/support/port_holder.h"
#include "tests/support/pty_pair.h"
#include "tests/support/without_rights.h"

#include <QFile>

#include <sys/stat.h>

namespace codewheel {
namespace {

TEST(PortHindrances, APortThatIsNotThereIsLookedForByName)
{
    const auto found = portHindrances(QStringLiteral("/dev/ttyNowhere"), Computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portMissing")});
    EXPECT_EQ(found[0].command, QStringLiteral("ls -l /dev/serial/by-id"));
}

TEST(PortHindrances, TellsTheGroupThatMayUseAPort)
{
    if (::getuid() != 0)
        GTEST_SKIP() << "only root can give a port to another group";
    const PtyPair pty;
    const QByteArray path = QFile::encodeName(pty.path());
    constexpr gid_t dialout = 20; // on Debian
    ASSERT_EQ(::chown(path.constData(), 0, dialout), 0);
    ASSERT_EQ(::chmod(path.constData(), 0660), 0);
    Hindrances found;
    {
        const WithoutRights without;
        found = portHindrances(pty.path(), Computer());
    }
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].id, HindranceId::noRights);
    EXPECT_EQ(found[0].weight, Hindrance::Weight::prevents);
    EXPECT_EQ(found[0].command, QStringLiteral("sudo usermod -aG dialout $USER"));
    EXPECT_TRUE(found[0].sentence.contains(u"its group dialout")) << found[0].sentence.toStdString();
}

TEST(PortHindrances, ThatNoGroupMayUseAPortIsNoReasonToJoinRoot)
{
    const PtyPair pty;
    const QByteArray path = QFile::encodeName(pty.path());
    ASSERT_EQ(::chmod(path.constData(), 0), 0);
    if (::getuid() == 0) {
        ASSERT_EQ(::chown(path.constData(), 0, 0), 0);
    }
    const WithoutRights without;
    const auto found = portHindrances(pty.path(), Computer());
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].id, HindranceId::noRightsForAnyone);
    EXPECT_TRUE(found[0].sentence.contains(u"no group of users may")) << found[0].sentence.toStdString();
    EXPECT_EQ(found[0].command, QStringLiteral("sudo setfacl -m u:$USER:rw %1").arg(pty.path()));
}

// A user without root's rights cannot change the group: then it is the one that the system gives to
// terminals.
TEST(PortHindrances, AGroupThatIsNotForPortsIsNamedButNotToBeJoined)
{
    const PtyPair pty;
    constexpr gid_t disk = 6; // on Debian
    const QByteArray path = QFile::encodeName(pty.path());
    if (::getuid() == 0) {
        ASSERT_EQ(::chown(path.constData(), 0, disk), 0);
    }
    ASSERT_EQ(::chmod(path.constData(), 0060), 0);
    const QString group = QFileInfo(pty.path()).group();
    const WithoutRights without;
    const auto found = portHindrances(pty.path(), Computer());
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].id, HindranceId::noRightsForAnyone);
    EXPECT_EQ(found[0].weight, Hindrance::Weight::prevents);
    EXPECT_TRUE(found[0].sentence.contains(QStringLiteral("Its group %1 may, but").arg(group)))
        << found[0].sentence.toStdString();
    EXPECT_EQ(found[0].command, QStringLiteral("sudo setfacl -m u:$USER:rw %1").arg(pty.path()));
}

TEST(PortHindrances, WhatIsNoPortIsSaidAndNeverGivenAway)
{
    const WithoutRights without;
    for (const char *path : {"/etc/shadow", "/dev/null", "/tmp", "/proc/self/mem"}) {
        const auto found = portHindrances(QString::fromLatin1(path), Computer());
        ASSERT_EQ(found.size(), 1U) << path;
        EXPECT_EQ(found[0].id, HindranceId::notAPort);
        EXPECT_EQ(found[0].command, QString());
    }
}

TEST(PortHindrances, RightsGivenSinceTheLoginCountFromTheNextOneOn)
{
    const PtyPair pty;
    const QByteArray path = QFile::encodeName(pty.path());
    if (::getuid() != 0)
        GTEST_SKIP() << "only root can give a port to another group";
    constexpr gid_t dialout = 20;
    ASSERT_EQ(::chown(path.constData(), 0, dialout), 0);
    ASSERT_EQ(::chmod(path.constData(), 0660), 0);
    MadeComputer made;
    made.file(QStringLiteral("/etc/group"), "audio:x:29:\ndialout:x:20:max,nobody");
    Hindrance found;
    {
        const WithoutRights without;
        found = rightsHindrance(pty.path(), made.computer());
    }
    EXPECT_EQ(found.id, HindranceId::rightsAtNextLogin);
    EXPECT_EQ(found.command, QStringLiteral("newgrp dialout"));
}

TEST(PortHindrances, NamesTheProgramThatHasThePort)
{
    MadeComputer made;
    made.process(4711, "minicom");
    made.link(QStringLiteral("/proc/4711/fd/3"), "/dev/ttyS7");
    made.process(312, "ModemManager");
    made.link(QStringLiteral("/proc/312/fd/9"), "/dev/ttyS7");
    const auto found = holderHindrances(QStringLiteral("/dev/ttyS7"), made.computer());
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].command, QStringLiteral("sudo systemctl stop ModemManager.service"));
    EXPECT_TRUE(found[1].sentence.contains(u"minicom (process 4711)")) << found[1].sentence.toStdString();
    EXPECT_EQ(found[1].command, QStringLiteral("kill 4711"));
}

TEST(PortHindrances, ARealProgramThatHasThePortIsNamedAndCanBeEnded)
{
    PtyPair pty;
    PortHolder holder(QStringLiteral(CODEWHEEL_PYTHON), pty.path());
    pty.leave();
    const Hindrances found = portHindrances(pty.path(), Computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portTaken")});
    EXPECT_TRUE(found[0].sentence.contains(u"the program python")) << found[0].sentence.toStdString();
    EXPECT_TRUE(found[0].sentence.contains(QStringLiteral("(process %1)").arg(holder.id())))
        << found[0].sentence.toStdString();
    EXPECT_EQ(found[0].command, QStringLiteral("kill %1").arg(holder.id()));
    const auto refused = hindranceOf({RefusalKind::link, RefusalId::portInUse, {pty.path()}});
    ASSERT_TRUE(refused);
    EXPECT_EQ(*refused, found[0]);
    holder.end();
    EXPECT_TRUE(portHindrances(pty.path(), Computer()).empty());
}

// What a process of root has open cannot be seen, but the terminal that controls it can.
TEST(PortHindrances, ALoginThatTheSystemOffersIsSwitchedOffByItsService)
{
    MadeComputer made;
    made.file(QStringLiteral("/sys/class/tty/ttyS0/dev"), "4:64");
    made.process(612, "agetty", 0x440);
    made.process(613, "bash", 0x441);
    const auto found = holderHindrances(QStringLiteral("/dev/ttyS0"), made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portTaken")});
    EXPECT_TRUE(found[0].sentence.contains(u"offers a login at /dev/ttyS0"))
        << found[0].sentence.toStdString();
    EXPECT_EQ(found[0].command, QStringLiteral("sudo systemctl disable --now serial-getty@ttyS0.service"));
    made.file(QStringLiteral("/run/systemd/generator/getty.target.wants/serial-getty@ttyS0.service"));
    EXPECT_EQ(holderHindrances(QStringLiteral("/dev/ttyS0"), made.computer())[0].command,
              QStringLiteral("sudo systemctl mask --now serial-getty@ttyS0.service"))
        << "one that is made at each start of the computer comes back otherwise";
}

TEST(PortHindrances, AProgramOfAnotherUserIsKnownByItsLock)
{
    MadeComputer made;
    made.file(QStringLiteral("/dev/ttyUSB0"));
    made.link(QStringLiteral("/dev/serial/by-id/usb-FTDI"), "../../ttyUSB0");
    made.file(QStringLiteral("/proc/4711/stat"), "4711 (mgetty) S 1 1 1 0 -1"); // no folder "fd" to be seen
    made.file(QStringLiteral("/run/lock/LCK..ttyUSB0"), "      4711 mgetty root");
    const auto found = holderHindrances(QStringLiteral("/dev/serial/by-id/usb-FTDI"), made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portTaken")});
    EXPECT_TRUE(found[0].sentence.contains(u"mgetty (process 4711)")) << found[0].sentence.toStdString();
    EXPECT_EQ(found[0].command, QStringLiteral("sudo kill 4711"));
}

TEST(PortHindrances, ALockIsNotBelievedWhereItsProgramIsSeenNotToHaveThePort)
{
    MadeComputer made;
    made.process(4711, "bash");
    made.file(QStringLiteral("/run/lock/LCK..ttyUSB0"), "      4711");
    EXPECT_TRUE(holderHindrances(QStringLiteral("/dev/ttyUSB0"), made.computer()).empty());
}

// Qt cannot remove a lock of root, and opens no port that has one.
TEST(PortHindrances, ALockThatAProgramOfAnotherUserHasLeftIsToBeRemoved)
{
    MadeComputer made;
    made.file(QStringLiteral("/run/lock/LCK..ttyUSB0"), "      4711");
    made.file(QStringLiteral("/run/lock/LCK..ttyUSB1"), "no number");
    const QString port = QStringLiteral("/dev/ttyUSB0");
    EXPECT_TRUE(holderHindrances(port, made.computer()).empty()) << "the user's own does not matter";
    if (::getuid() != 0)
        GTEST_SKIP() << "only root has files of another user";
    const WithoutRights without;
    const auto found = holderHindrances(port, made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portLocked")});
    EXPECT_EQ(found[0].weight, Hindrance::Weight::prevents);
    EXPECT_EQ(found[0].command, QStringLiteral("sudo rm /run/lock/LCK..ttyUSB0"));
    EXPECT_TRUE(holderHindrances(QStringLiteral("/dev/ttyUSB1"), made.computer()).empty());
}

TEST(PortHindrances, ThisProgramIsNotToldToEndItself)
{
    const PtyPair pty; // the test holds its near end
    const auto found = portHindrances(pty.path(), Computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("portTaken")});
    EXPECT_TRUE(found[0].sentence.contains(u"another bus of this program"));
    EXPECT_TRUE(found[0].command.isEmpty());
}

TEST(PortHindrances, AnAdapterThatCollectsBytesIsSlow)
{
    const PtyPair pty;
    MadeComputer made;
    const QString name = pty.path().section(u'/', -1);
    const QString timer = QStringLiteral("/sys/bus/usb-serial/devices/%1/latency_timer").arg(name);
    made.file(pty.path());
    made.file(timer, "16");
    const auto slow = portHindrances(pty.path(), made.computer());
    ASSERT_EQ(idsOf(slow), std::vector{QStringLiteral("slowPort")});
    EXPECT_EQ(slow[0].weight, Hindrance::Weight::slows);
    EXPECT_TRUE(slow[0].sentence.contains(u"16 ms"));
    EXPECT_EQ(slow[0].command, QStringLiteral("echo 1 | sudo tee ") + timer);
    made.file(timer, "1");
    EXPECT_TRUE(portHindrances(pty.path(), made.computer()).empty());
}

} // namespace
} // namespace codewheel
