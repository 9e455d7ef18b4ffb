// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/interbus/gateway_peer.h"

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/words/device_number.h"
#include "project/project_file.h"
#include "tests/support/plans.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int answerPatience = 60'000; // ms

} // namespace

GatewayPeer::GatewayPeer(const QString &options)
    : m_isRtu(options.contains(QStringLiteral("--rtu")))
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.start(QStringLiteral(DEBIAN_PYTHON3), QStringList{QStringLiteral(CODEWHEEL_GATEWAY_PEER)} +
                                                        options.split(u' ', Qt::SkipEmptyParts));
    m_where = ask("");
}

GatewayPeer::~GatewayPeer()
{
    vanish();
}

void GatewayPeer::vanish()
{
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.kill();
    EXPECT_TRUE(m_process.waitForFinished(answerPatience));
}

QString GatewayPeer::ask(const char *question)
{
    m_process.write(question);
    while (!m_process.canReadLine())
        if (!m_process.waitForReadyRead(answerPatience)) {
            ADD_FAILURE() << "the peer says nothing";
            return {};
        }
    return QString::fromLocal8Bit(m_process.readLine()).trimmed();
}

QString GatewayPeer::link(const QString &settings) const
{
    const QString where =
        m_isRtu ? QStringLiteral("modbus-rtu:") + m_where : QStringLiteral("modbus-tcp:127.0.0.1:") + m_where;
    return settings.isEmpty() ? where : where + u',' + settings;
}

int GatewayPeer::writes()
{
    return ask("writes\n").toInt();
}

QString GatewayPeer::out()
{
    return ask("out\n");
}

RingProject::RingProject(int encoders, const ProjectLink &link)
{
    Project project;
    changeRing(project, [&](RingPlan &ring) { ring.link = link; });
    for (int segment = 1; segment <= encoders; ++segment) {
        ProjectDevice device;
        device.participant =
            RingDevice{DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")};
        project.devices.push_back(device);
    }
    EXPECT_TRUE(saveProject(project, file()));
}

CliRun RingProject::run(const QString &line, const QString &link, const Person &person) const
{
    const QString command = line.section(u' ', 0, 0);
    const bool writes = QStringList{QStringLiteral("write"), QStringLiteral("preset"), QStringLiteral("cams"),
                                    QStringLiteral("velocity"), QStringLiteral("reset")}
                            .contains(command);
    return runLine(
        QStringLiteral("%1 --link %2 --project %3").arg(line, link, file()) +
            (writes ? QStringLiteral(" --ledger ") + path(QStringLiteral("ledger.sqlite")) : QString()),
        person);
}

ProjectLink plannedLink(const GatewayPeer &peer)
{
    const GatewaySettings gateway{.host = QStringLiteral("127.0.0.1"), .tcpPort = peer.where().toInt()};
    return {linkKindOf(gateway), linkTexts(gateway)};
}

} // namespace codewheel
