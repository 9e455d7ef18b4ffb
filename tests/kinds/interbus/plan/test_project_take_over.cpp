// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/kinds/interbus/ring/written_ring.h"

#include <gtest/gtest.h>
#include <numeric>

namespace codewheel {
namespace {

// Each device has something of everything, and its old number as its station.
Project projectOf(const char *ring)
{
    Project project;
    for (const RingDevice &participant : writtenRing(ring)) {
        ProjectDevice device;
        device.participant = participant;
        device.participant.deviceKey = QStringLiteral("named");
        device.station = participant.number.toString();
        device.group = QStringLiteral("hoist");
        device.note = QStringLiteral("note");
        device.label.serialNumber = QStringLiteral("4711");
        device.set(GivenAddresses{.in = 20, .out = 22});
        device.wanted = {{Parameter::steps, 100}};
        device.wantedCams = {CamProgram{}};
        device.stored = {{Parameter::steps, 90, Evidence::read, {}}};
        device.storedCams = {StoredCams{}};
        project.devices.push_back(device);
    }
    return project;
}

Project allTakenOver(const Project &project, const RingStructure &connected)
{
    const Comparison comparison = compareRings(structureOf(project), connected);
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), std::size_t{0});
    return takenOver(project, connected, comparison, lines);
}

RingStructure withoutMakes(RingStructure ring)
{
    for (RingDevice &participant : ring)
        participant.deviceKey.clear();
    return ring;
}

TEST(ProjectTakeOver, OfAllLinesGivesTheConnectedRing)
{
    const RingStructure connected = writtenRing("K3 K1 BT .K3L DI");
    EXPECT_EQ(withoutMakes(structureOf(allTakenOver(projectOf("DI K3 K3 BT /K1"), connected))), connected);
    EXPECT_EQ(structureOf(allTakenOver(Project(), connected)), connected);
    EXPECT_TRUE(allTakenOver(projectOf("K3"), {}).devices.empty());
}

TEST(ProjectTakeOver, ADeviceThatMovedKeepsAllButItsNumber)
{
    const Project before = projectOf("DI K3 K3 K1");
    const Project after = allTakenOver(before, writtenRing("K3 K3 K1 DI"));
    ProjectDevice moved = before.devices[0];
    moved.participant.number = NodeId("4.0");
    EXPECT_EQ(after.devices[3], moved);
    ProjectDevice stayed = before.devices[1];
    stayed.participant.number = NodeId("1.0");
    EXPECT_EQ(after.devices[0], stayed);
}

TEST(ProjectTakeOver, AnotherDeviceKeepsWhatBelongsToThePlace)
{
    const Project before = projectOf("K3 K2");
    const Project after = allTakenOver(before, writtenRing("K3 K1"));
    ProjectDevice expected;
    expected.participant = writtenRing("K3 K1")[1];
    expected.station = QStringLiteral("2.0");
    expected.group = QStringLiteral("hoist");
    expected.note = QStringLiteral("note");
    expected.set(GivenAddresses{.in = 20, .out = 22});
    EXPECT_EQ(after.devices[0], before.devices[0]);
    EXPECT_EQ(after.devices[1], expected);
}

TEST(ProjectTakeOver, OfNoLineChangesNothing)
{
    const Project project = projectOf("K3 BT .DI K1");
    const RingStructure connected = writtenRing("K1 K2");
    EXPECT_EQ(takenOver(project, connected, compareRings(structureOf(project), connected), {}), project);
}

} // namespace
} // namespace codewheel
