// SPDX-License-Identifier: GPL-3.0-or-later
// What only this kind has of a device, in a project that knows nothing of it.
#include "project/bus_plans.h"
#include "project/project_file.h"
#include "tests/kinds/plain/plain_kind.h"
#include "vocabulary/refusal_text.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Settings = test::PlainNodeSettings;

class PlainProject : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<test::PlainKind>()); }
    PlainProject()
    {
        planBus(project, test::plainId, *busKind(u"plain")).name = QStringLiteral("Yard");
        std::vector<ProjectDevice> devices(2);
        devices[0].standAt(test::plainHoist);
        devices[0].participant.deviceKey = QStringLiteral("plain-node");
        devices[0].set(Settings{.heartbeat = 250});
        devices[1].standAt(test::plainGate);
        setDevicesOn(project, test::plainId, std::move(devices));
    }
    QByteArray written()
    {
        EXPECT_TRUE(saveProject(project, path));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("plain.codewheel"));
    Project project;
};

TEST_F(PlainProject, KeepsASettingOfADeviceThroughSavingAndOpening)
{
    EXPECT_EQ(written().count("\"heartbeat\": 250"), 1) << "not where it is the usual one";
    const auto opened = loadProject(path);
    ASSERT_TRUE(opened);
    EXPECT_EQ(*opened, project);
    EXPECT_EQ(findDevice(*opened, test::plainHoist)->its<Settings>().heartbeat, 250);
    EXPECT_EQ(findDevice(*opened, test::plainGate)->its<Settings>().heartbeat, 0);
}

TEST_F(PlainProject, KeepsWhatOnlyItsBusTellsOfADevice)
{
    const KindData told{test::PlainDetails{.inputBytes = 3}};
    findDevice(project, test::plainHoist)->participant.details = told;
    EXPECT_EQ(written().count("\"inputBytes\": 3"), 1);
    EXPECT_EQ(*loadProject(path), project);
    const auto changed = busKind(u"plain")->planRules().change(
        project, test::plainId, 1,
        {.number = {}, .deviceKey = QStringLiteral("plain-node"), .details = told});
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->devices[1].participant.details, told) << "it is of the device, not of its place";
    EXPECT_EQ(changed->devices[1].place(), test::plainGate);
}

TEST_F(PlainProject, ASettingBackAtTheUsualOneIsNone)
{
    ProjectDevice &device = *findDevice(project, test::plainHoist);
    const ProjectDevice before = device;
    device.set(Settings{.heartbeat = 0});
    EXPECT_EQ(device.settings, KindData());
    EXPECT_FALSE(written().contains("heartbeat"));
    device.set(Settings{.heartbeat = 250});
    EXPECT_EQ(device, before);
}

TEST_F(PlainProject, ItsKindChecksWhatTheFileSays)
{
    QByteArray bytes = written();
    bytes.replace("\"heartbeat\": 250", "\"heartbeat\": 10001");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    const auto opened = loadProject(path);
    ASSERT_FALSE(opened);
    EXPECT_THAT(refusalText(opened.error()).toStdString(),
                testing::HasSubstr("buses[1].devices[0].heartbeat"));
}

} // namespace
} // namespace codewheel
