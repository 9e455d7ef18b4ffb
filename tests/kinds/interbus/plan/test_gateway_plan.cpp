// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/plan/check_project.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/words/device_number.h"
#include "project/bus_kind.h"
#include "project/project_json.h"
#include "tests/support/plans.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Texts = std::map<QString, QString>;

Project ringBehind(const char *kind, const Texts &settings, int encoders = 2)
{
    Project project;
    changeRing(project, [&](RingPlan &ring) { ring.link = {QString::fromLatin1(kind), settings}; });
    for (int segment = 1; segment <= encoders; ++segment) {
        ProjectDevice device;
        device.participant =
            RingDevice{DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")};
        project.devices.push_back(device);
    }
    return project;
}

const Texts someGateway{{QStringLiteral("host"), QStringLiteral("192.168.0.5")},
                        {QStringLiteral("unit"), QStringLiteral("3")},
                        {QStringLiteral("order"), QStringLiteral("low")}};

QStringList findingsOf(const Project &project)
{
    QStringList texts;
    for (const Finding &finding : checkProject(project, processAddresses(project)))
        texts << QStringLiteral("%1: %2").arg(finding.device).arg(finding.text);
    return texts;
}

// With one text of the file replaced.
QString refusalOf(const Project &project, const char *text, const char *by)
{
    QByteArray json = projectToJson(project);
    EXPECT_TRUE(json.contains(text)) << json.toStdString();
    const auto read = projectFromJson(json.replace(text, by), QStringLiteral("crane.codewheel"));
    return read ? QString() : refusalText(read.error());
}

TEST(GatewayPlan, IsKeptInTheFileOfTheProject)
{
    const Project project = ringBehind("modbus-tcp", someGateway);
    const auto read = projectFromJson(projectToJson(project), QStringLiteral("crane.codewheel"));
    ASSERT_TRUE(read) << refusalText(read.error()).toStdString();
    EXPECT_EQ(*read, project);
    const auto gateway = plannedGateway(*read, firstBus);
    ASSERT_TRUE(gateway && *gateway);
    EXPECT_EQ((*gateway)->host, QStringLiteral("192.168.0.5"));
    EXPECT_EQ((*gateway)->unit, 3);
    EXPECT_FALSE((*gateway)->highWordFirst);
}

TEST(GatewayPlan, IsShownAsItsUserKnowsIt)
{
    const BusKind &ring = *busKind(u"interbus");
    const auto text = [&](const Project &project) {
        return ring.linkText(findBus(project, firstBus)->settings);
    };
    EXPECT_EQ(text(ringBehind("modbus-tcp", someGateway)), QStringLiteral("192.168.0.5:502, unit 3"));
    EXPECT_EQ(text(ringBehind("modbus-rtu", {{QStringLiteral("port"), QStringLiteral("/dev/ttyUSB0")}})),
              QStringLiteral("/dev/ttyUSB0, 19200 Bd, 8E1, unit 1"));
    EXPECT_FALSE(ring.isTraining(findBus(ringBehind("modbus-tcp", someGateway), firstBus)->settings));
}

TEST(GatewayPlan, AWrongSettingIsReportedWithLineAndKey)
{
    const Project project = ringBehind("modbus-tcp", someGateway);
    const QString range = refusalOf(project, "\"unit\": \"3\"", "\"unit\": \"256\"");
    EXPECT_TRUE(range.contains(QStringLiteral("buses[0].link.settings.unit"))) << range.toStdString();
    EXPECT_TRUE(range.contains(QStringLiteral("from 0 to 255"))) << range.toStdString();
    const QByteArray json = projectToJson(project);
    const auto line = json.first(json.indexOf("\"unit\": \"3\"")).count('\n') + 1;
    EXPECT_TRUE(range.contains(QStringLiteral("line %1").arg(line))) << range.toStdString();
    const QString name = refusalOf(project, "\"unit\": \"3\"", "\"baud\": \"9600\"");
    EXPECT_TRUE(name.contains(QStringLiteral("buses[0].link.settings.baud"))) << name.toStdString();
    EXPECT_FALSE(
        refusalOf(project, "\"host\": \"192.168.0.5\"", "\"host\": \"a\", \"port\": \"0\"").isEmpty());
    EXPECT_FALSE(refusalOf(project, "\"unit\": \"3\"", "\"unit\": 3").isEmpty()); // no text
}

TEST(GatewayPlan, ALinkOfANewerProgramIsKeptAsItIs)
{
    const Project project = ringBehind("opc-ua", {{QStringLiteral("unit"), QStringLiteral("everything")}});
    EXPECT_EQ(projectFromJson(projectToJson(project), QStringLiteral("crane.codewheel")), project);
    EXPECT_FALSE(plannedGateway(project, firstBus));
    EXPECT_EQ(findingsOf(project), QStringList());
}

TEST(GatewayPlan, AnImageThatCannotBeOpensAndIsFound)
{
    Texts settings = someGateway;
    EXPECT_EQ(findingsOf(ringBehind("modbus-tcp", settings)), QStringList());
    settings[QStringLiteral("in-area")] = QStringLiteral("holding"); // where OUT is
    const Project overlapping = ringBehind("modbus-tcp", settings);
    EXPECT_TRUE(projectFromJson(projectToJson(overlapping), QStringLiteral("crane.codewheel")));
    EXPECT_EQ(findingsOf(overlapping),
              QStringList(QStringLiteral("0: IN (registers 0 to 3) and OUT (0 to 3) overlap. Change the "
                                         "registers of the link.")));
    settings[QStringLiteral("in")] = QStringLiteral("65532");
    EXPECT_EQ(findingsOf(ringBehind("modbus-tcp", settings)), QStringList());
    EXPECT_EQ(findingsOf(ringBehind("modbus-tcp", settings, 3)).size(), 1); // behind the last register
    EXPECT_EQ(findingsOf(ringBehind("modbus-tcp", settings, 0)), QStringList());
}

TEST(GatewayPlan, TheCheckKnowsWhatTheProjectKnowsOfTheEncoders)
{
    const Catalog catalog = Catalog::builtIn();
    Project project = ringBehind("modbus-tcp", someGateway, 3);
    project.devices[1].stored = {{Parameter::steps, 1000, Evidence::read, {}},
                                 {Parameter::revolutions, 16, Evidence::read, {}}};
    project.devices[2].participant.deviceKey.clear();
    const auto devices = checkedDevices(project, firstBus, catalog);
    ASSERT_EQ(devices.size(), 3U);
    EXPECT_EQ(devices[0].sender.totalRange, 8192 * 4096); // what its disc has
    EXPECT_EQ(devices[1].sender.totalRange, 256'000);     // 4096 turns
    EXPECT_EQ(devices[2].sender.totalRange, std::nullopt);
    ASSERT_TRUE(devices[2].sender.device);
    EXPECT_TRUE(devices[2].sender.device->isGeneric());
}

} // namespace
} // namespace codewheel
