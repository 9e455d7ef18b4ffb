// SPDX-License-Identifier: GPL-3.0-or-later
// How gateways are named by --link, and what is refused before anything connects.
#include "cli/kinds/interbus/gateway_link_text.h"
#include "tests/cli/kinds/interbus/gateway_peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

GatewaySettings gatewayLink(const char *text)
{
    const auto gateway = gatewayMeant(*LinkText::parse(QString::fromLatin1(text)));
    EXPECT_TRUE(gateway) << text << ": " << (gateway ? "" : gateway.error().text.toStdString());
    return gateway.value_or(GatewaySettings());
}

Complaint refusalOf(const QString &link)
{
    const auto made = linksMeant(link, nullptr);
    return made ? Complaint{.key = {}, .text = {}} : made.error();
}

TEST(CliGatewayLink, AHostStandsByItselfOrWithPortAndSettings)
{
    EXPECT_EQ(gatewayLink("modbus-tcp:gateway.hall"),
              (GatewaySettings{.host = QStringLiteral("gateway.hall")}));
    GatewaySettings all{.host = QStringLiteral("192.168.0.5"),
                        .tcpPort = 1502,
                        .unit = 3,
                        .inArea = RegisterArea::holding,
                        .inFirst = 100,
                        .outFirst = 200,
                        .writesWithRead = true,
                        .highWordFirst = false,
                        .statusRegister = 300,
                        .controlRegister = 301,
                        .readsBack = false,
                        .pollInterval = 10ms,
                        .reactionDelay = 5ms,
                        .timeOut = 250ms,
                        .retries = 0};
    EXPECT_EQ(gatewayLink("modbus-tcp:192.168.0.5:1502,unit=3,in-area=holding,in=100,out=200,write=23,"
                          "order=low,status=300,control=301,read-back=off,interval=10,delay=5,time-out=250,"
                          "retries=0"),
              all);
}

TEST(CliGatewayLink, AnIpv6AddressStandsInBrackets)
{
    EXPECT_EQ(gatewayLink("modbus-tcp:[fe80::1]").host, QStringLiteral("fe80::1"));
    const GatewaySettings loopback = gatewayLink("modbus-tcp:[::1]:1502,unit=0");
    EXPECT_EQ(loopback.host, QStringLiteral("::1"));
    EXPECT_EQ(loopback.tcpPort, 1502);
    EXPECT_EQ(loopback.unit, 0);
}

TEST(CliGatewayLink, ASerialPortIsAPathOrAName)
{
    const GatewaySettings rtu = gatewayLink("modbus-rtu:ttyUSB0,baud=9600,format=8N2,unit=247");
    EXPECT_EQ(rtu.serialPort, QStringLiteral("/dev/ttyUSB0"));
    EXPECT_EQ(rtu.serial.baudRate, 9'600);
    EXPECT_EQ(rtu.serial.stopBits, 2);
    EXPECT_EQ(rtu.unit, 247);
    EXPECT_EQ(gatewayLink("modbus-rtu:/dev/pts/5").serialPort, QStringLiteral("/dev/pts/5"));
}

TEST(CliGatewayLink, WhatIsWrongIsNamedWithWhatIsAllowed)
{
    struct
    {
        const char *link;
        const char *key;
        const char *says;
    } const rows[] = {
        {"modbus-tcp:", "hostMissing", "modbus-tcp:192.168.0.5"},
        {"modbus-tcp:,unit=1", "hostMissing", "host"},
        {"modbus-tcp::502", "hostMissing", "host"},
        {"modbus-tcp:a:", "portMissing", "\"a:\""},
        {"modbus-tcp:a:0", "linkSettingWrong", "1 to 65535"},
        {"modbus-tcp:a:65536", "linkSettingWrong", "1 to 65535"},
        {"modbus-tcp:a:modbus", "linkSettingWrong", "port"},
        {"modbus-tcp:fe80::1", "addressNotInBrackets", "[fe80::1]"},
        {"modbus-tcp:[fe80::1", "addressNotUnderstood", "[fe80::1"},
        {"modbus-tcp:[]", "addressNotUnderstood", "[]"},
        {"modbus-tcp:[::1]502", "addressNotUnderstood", "[::1]502"},
        {"modbus-tcp:[::1]:", "addressNotUnderstood", "[::1]:"},
        {"modbus-tcp:a,unit=256", "linkSettingWrong", "0 to 255"},
        {"modbus-tcp:a,unit", "linkSettingWrong", "unit"},
        {"modbus-tcp:a,unit=1,unit=2", "linkSettingGivenTwice", "unit"},
        {"modbus-tcp:a,order=middle", "linkSettingWrong", "high or low"},
        {"modbus-tcp:a,baud=9600", "linkSettingUnknown", "in-area"},
        {"modbus-tcp:a,host=b", "linkSettingUnknown", "host"},
        {"modbus-tcp:a,", "linkSettingUnknown", "in-area"},
        {"modbus-rtu:", "portMissing", "modbus-rtu:ttyUSB0"},
        {"modbus-rtu:ttyUSB0,unit=0", "linkSettingWrong", "1 to 247"},
        {"modbus-rtu:ttyUSB0,format=7E1", "linkSettingWrong", "8E1"},
        {"modbus-udp:a", "unknownLink", "modbus-tcp:HOST"},
    };
    for (const auto &row : rows) {
        const Complaint complaint = refusalOf(QString::fromLatin1(row.link));
        EXPECT_EQ(complaint.key.toStdString(), row.key) << row.link;
        EXPECT_EQ(complaint.exit, ExitCode::badInput) << row.link;
        EXPECT_THAT(complaint.text.toStdString(), HasSubstr(row.says)) << row.link;
    }
}

TEST(CliGatewayLink, NeedsAProjectForItsRing)
{
    const CliRun run = runLine(QStringLiteral("monitor 1.0 --link modbus-tcp:127.0.0.1:1"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err, HasSubstr("--project FILE"));
}

TEST(CliGatewayLink, WhatAGatewayCannotDoIsSaidBeforeItConnects)
{
    const RingProject project;
    const QString nowhere = QStringLiteral("modbus-tcp:127.0.0.1:1"); // refuses connections
    struct
    {
        QString line;
        const char *key;
    } const rows[] = {
        {QStringLiteral("scan --json"), "noIdCycle"},
        {QStringLiteral("compare %1 --json").arg(project.file()), "noIdCycle"},
        {QStringLiteral("master --json"), "masterServiceNotSupported"},
        {QStringLiteral("master start --json"), "masterServiceNotSupported"},
        {QStringLiteral("master segment 1 off --yes --json"), "masterServiceNotSupported"},
        {QStringLiteral("master alarm-stop --patience 1 --json"), "connectionRefused"},
        {QStringLiteral("monitor 1.0 --json"), "connectionRefused"},
    };
    for (const auto &row : rows) {
        const CliRun run = project.run(row.line, nowhere);
        EXPECT_EQ(run.exit, 1) << row.line.toStdString();
        EXPECT_EQ(errorKey(run), row.key) << row.line.toStdString();
    }
    // Without a project, too.
    EXPECT_EQ(errorKey(runLine(QStringLiteral("scan --json --link ") + nowhere)), "noIdCycle");
}

TEST(CliGatewayLink, AnAlarmStopThatDoesNotArriveSaysSoOnceItsPatienceEnds)
{
    const CliRun run = RingProject().run(QStringLiteral("master alarm-stop --patience 1"),
                                         QStringLiteral("modbus-tcp:127.0.0.1:1"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The zeros of the ALARM STOP have not arrived within 1 s."));
}

TEST(CliGatewayLink, PlacesAreThoseOfTheProject)
{
    const CliRun run =
        RingProject().run(QStringLiteral("monitor 9.0"), QStringLiteral("modbus-tcp:127.0.0.1:1"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err, HasSubstr("1.0, 2.0, 3.0"));
}

TEST(CliGatewayLink, AHostThatIsNotThereIsSaid)
{
    const RingProject project;
    const CliRun run =
        project.run(QStringLiteral("monitor 1.0 --json"), QStringLiteral("modbus-tcp:no-such-host.invalid"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "hostNotFound");
    EXPECT_EQ(errorKey(project.run(QStringLiteral("monitor 1.0 --json"),
                                   QStringLiteral("modbus-rtu:/dev/ttyNotThere"))),
              "portNotFound");
}

TEST(CliGatewayLink, SeveralRingsNeedOneThatIsAtTheGateway)
{
    const auto run = [](const QString &port) {
        return runLine(QStringLiteral("monitor 1.0 --json --link modbus-tcp:127.0.0.1:%1 --project %2")
                           .arg(port, QStringLiteral(CODEWHEEL_ROOT "/tests/cli/two-rings.codewheel")));
    };
    EXPECT_EQ(errorKey(run(QStringLiteral("1"))), "ringNotUnique");
    EXPECT_EQ(errorKey(run(QStringLiteral("2"))), "connectionRefused"); // planned so
}

} // namespace
} // namespace codewheel
