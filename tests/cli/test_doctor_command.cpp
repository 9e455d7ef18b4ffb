// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/doctor.h"
#include "kinds/interbus/links/server_socket.h"
#include "links/serial_ports.h"
#include "tests/cli/cli_run.h"
#include "tests/support/pty_pair.h"
#include "tests/support/without_rights.h"

#include <QFile>
#include <QJsonArray>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

QJsonObject firstHindrance(const CliRun &run)
{
    return run.json()[u"hindrances"][0].toObject();
}

TEST(DoctorCommand, KnowsThatACanInterfaceIsMissing)
{
    const CliRun run = runLine(QStringLiteral("doctor --json --link can:nowhere0"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(firstHindrance(run)[u"id"].toString(), QStringLiteral("canMissing"));
    EXPECT_EQ(firstHindrance(run)[u"about"].toString(), QStringLiteral("nowhere0"));
}

TEST(DoctorCommand, SaysWhatIsWrongWithThePortOfALinkAndWhatToDo)
{
    const CliRun text = runLine(QStringLiteral("doctor --link esc:/dev/ttyNowhere"));
    EXPECT_EQ(text.exit, 1);
    EXPECT_THAT(text.out, HasSubstr("There is no port /dev/ttyNowhere."));
    EXPECT_THAT(text.out, HasSubstr("\n    ls -l /dev/serial/by-id\n"));
    EXPECT_THAT(text.err, HasSubstr("Something keeps a link from working"));
    const CliRun json = runLine(QStringLiteral("doctor --json --link esc:/dev/ttyNowhere"));
    EXPECT_EQ(errorKey(json), "linkHindered");
    const QJsonObject found = firstHindrance(json);
    EXPECT_EQ(found[u"id"].toString(), QStringLiteral("portMissing"));
    EXPECT_EQ(found[u"weight"].toString(), QStringLiteral("prevents"));
    EXPECT_EQ(found[u"about"].toString(), QStringLiteral("/dev/ttyNowhere"));
    EXPECT_EQ(found[u"command"].toString(), QStringLiteral("ls -l /dev/serial/by-id"));
}

TEST(DoctorCommand, APortWithoutRightsIsToldWithTheCommandThatGivesThem)
{
    const PtyPair pty;
    const QByteArray path = QFile::encodeName(pty.path());
    ASSERT_EQ(::chmod(path.constData(), 0), 0);
    CliRun run;
    {
        const WithoutRights without;
        run = runLine(QStringLiteral("doctor --json --link esc:") + pty.path());
    }
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(firstHindrance(run)[u"command"].toString().toStdString(), HasSubstr("sudo "));
    EXPECT_THAT(firstHindrance(run)[u"text"].toString().toStdString(),
                HasSubstr("You may not use " + path.toStdString()));
}

TEST(DoctorCommand, AGatewaySerialPortIsLookedAtLikeALine)
{
    const CliRun run = runLine(QStringLiteral("doctor --json --link modbus-rtu:/dev/ttyNowhere"));
    EXPECT_EQ(firstHindrance(run)[u"id"].toString(), QStringLiteral("portMissing"));
}

TEST(DoctorCommand, AGatewayIsConnectedAndLeft)
{
    auto server = listenAt({QStringLiteral("127.0.0.1"), 0});
    ASSERT_TRUE(server);
    const QString link = QStringLiteral("modbus-tcp:127.0.0.1:%1").arg(placeOf(*server).port);
    const CliRun there = runLine(QStringLiteral("doctor --json --link ") + link);
    for (const auto &hindrance : there.json()[u"hindrances"].toArray())
        EXPECT_FALSE(hindrance.toObject()[u"id"].toString().startsWith(QStringLiteral("host")));
    const auto [client, address] = acceptClient(*server);
    char byte = 0;
    EXPECT_EQ(::recv(client.get(), &byte, 1, 0), 0) << "it asks nothing, and goes";
    *server = Descriptor();
    const CliRun away = runLine(QStringLiteral("doctor --json --link ") + link);
    EXPECT_EQ(firstHindrance(away)[u"id"].toString(), QStringLiteral("hostRefuses"));
    EXPECT_THAT(firstHindrance(away)[u"command"].toString().toStdString(), HasSubstr("nc -vz 127.0.0.1 "));
}

// As a user without rights, who meets more hindrances.
TEST(DoctorCommand, WithoutALinkTheComputerIsLookedAt)
{
    QJsonArray ports;
    QJsonArray hindrances;
    CliRun run;
    {
        const WithoutRights without;
        for (const PortInfo &port : serialPorts())
            ports.append(port.path);
        for (const Hindrance &one : examine(serialPorts()))
            hindrances.append(hindranceKey(one.id) + u' ' + one.about + u' ' + one.sentence);
        run = runLine(QStringLiteral("doctor --json"));
    }
    QJsonArray toldPorts;
    for (const auto &port : run.json()[u"ports"].toArray())
        toldPorts.append(port.toObject()[u"port"]);
    QJsonArray told;
    for (const auto &row : run.json()[u"hindrances"].toArray()) {
        const QJsonObject one = row.toObject();
        told.append(one[u"id"].toString() + u' ' + one[u"about"].toString() + u' ' + one[u"text"].toString());
    }
    EXPECT_EQ(toldPorts, ports);
    EXPECT_EQ(told, hindrances);
    EXPECT_FALSE(told.isEmpty() && toldPorts.isEmpty()) << "that there is no port would be told";
}

TEST(DoctorCommand, TakesNoPlace)
{
    EXPECT_EQ(runLine(QStringLiteral("doctor 1.0")).exit, 2);
}

} // namespace
} // namespace codewheel
