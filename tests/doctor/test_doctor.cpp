// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor.h"
#include "doctor/link_hindrances.h"
#include "tests/doctor/made_computer.h"
#include "tests/support/pty_pair.h"
#include "tests/support/without_rights.h"

namespace codewheel {
namespace {

TEST(Doctor, NoPortAtAllIsSaidFirst)
{
    const MadeComputer made;
    const auto found = examine({}, made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("noPort")});
    EXPECT_TRUE(found[0].about.isEmpty());
}

TEST(Doctor, WhatPreventsComesBeforeWhatSlows)
{
    MadeComputer made;
    made.process(700, "ModemManager");
    made.adapter(QStringLiteral("1-2"), "0403", "6001", "FT232R USB UART", "ftdi_sio");
    made.file(QStringLiteral("/sys/class/net/can0/type"), "280");
    made.file(QStringLiteral("/sys/class/net/can0/flags"), "0x80");
    const PtyPair pty;
    const auto found = examine({{.path = pty.path()}}, made.computer());
    EXPECT_EQ(idsOf(found), (std::vector{QStringLiteral("canDown"), QStringLiteral("modemManager")}));
}

TEST(Doctor, OnlyACanInterfaceThatIsOffIsTold)
{
    MadeComputer made;
    const auto interface = [&](const QString &name, const QByteArray &type, const QByteArray &flags) {
        made.file(QStringLiteral("/sys/class/net/%1/type").arg(name), type);
        made.file(QStringLiteral("/sys/class/net/%1/flags").arg(name), flags);
    };
    interface(QStringLiteral("can0"), "280", "0x400c0");
    interface(QStringLiteral("can1"), "280", "0x400c1");
    interface(QStringLiteral("eth0"), "1", "0x1002");
    const auto found = canHindrances(made.computer());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].about, QStringLiteral("can0"));
    EXPECT_EQ(found[0].command, QStringLiteral("sudo ip link set can0 up type can bitrate 125000"));
}

TEST(Doctor, AServersPortBelowTheLimitNeedsRights)
{
    MadeComputer made;
    made.file(QStringLiteral("/proc/sys/net/ipv4/ip_unprivileged_port_start"), "1024");
    MadeComputer other;
    other.file(QStringLiteral("/proc/sys/net/ipv4/ip_unprivileged_port_start"), "2000");
    const auto found = serverPortHindrances(502, Hindrance::Weight::remark, made.computer());
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].command, QStringLiteral("sudo sysctl net.ipv4.ip_unprivileged_port_start=502"));
    EXPECT_TRUE(serverPortHindrances(1502, Hindrance::Weight::remark, made.computer()).empty());
    const auto higher = serverPortHindrances(1502, Hindrance::Weight::remark, other.computer());
    ASSERT_EQ(higher.size(), 1U);
    EXPECT_TRUE(higher[0].sentence.contains(u"from 2000 on")) << higher[0].sentence.toStdString();
    made.file(QStringLiteral("/proc/self/status"), "Name:\tcodewheel\nCapEff:\t0000000000000400");
    EXPECT_TRUE(serverPortHindrances(502, Hindrance::Weight::remark, made.computer()).empty())
        << "it was given the right";
}

} // namespace
} // namespace codewheel
