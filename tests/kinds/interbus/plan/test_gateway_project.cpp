// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/gateway_project.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/kinds/interbus/ring/written_ring.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr BusId thirdBus{3};
const GatewaySettings seat{.host = QStringLiteral("192.0.2.7"), .tcpPort = 1'502, .unit = 5};

// The third of several buses, with what is planned and known of its devices.
Project classroom()
{
    Project project = projectOf(writtenRing("K3 K1"), thirdBus);
    project.title = QStringLiteral("Class");
    for (ProjectDevice &device : project.devices) {
        device.station = QStringLiteral("Hoist");
        device.wanted = {{Parameter::steps, 100}};
        device.stored = {{Parameter::steps, 90, Evidence::read, {}}};
        device.storedCams = {StoredCams{}};
        device.lastPosition = LastPosition{};
    }
    project.sequences = {{QStringLiteral("Sequence"), {}}};
    return project;
}

TEST(GatewayProject, HasTheRingAsPlannedAndNothingElse)
{
    const Project project =
        gatewayProject(classroom(), thirdBus, writtenRing("K3 K1"), seat, QStringLiteral("Seat"));
    ASSERT_EQ(project.buses.size(), 1U);
    EXPECT_EQ(project.buses.front().id, firstBus);
    EXPECT_EQ(project.buses.front().name, QStringLiteral("Seat"));
    EXPECT_EQ(project.title, QStringLiteral("Class"));
    EXPECT_TRUE(project.sequences.empty());
    EXPECT_EQ(structureOf(project), writtenRing("K3 K1"));
    for (const ProjectDevice &device : project.devices) {
        EXPECT_EQ(device.station, QStringLiteral("Hoist"));
        EXPECT_FALSE(device.wanted.empty());
        EXPECT_TRUE(device.stored.empty() && device.storedCams.empty() && !device.lastPosition)
            << "not of this encoder";
    }
    const auto gateway = plannedGateway(project, firstBus);
    ASSERT_TRUE(gateway && *gateway);
    EXPECT_EQ(**gateway, seat);
}

TEST(GatewayProject, OfOtherDevicesThanPlannedHasWhatIsOffered)
{
    const Project project =
        gatewayProject(classroom(), thirdBus, writtenRing("K3 K3 K1"), seat, QStringLiteral("Seat"));
    EXPECT_EQ(structureOf(project), writtenRing("K3 K3 K1"));
    EXPECT_EQ(project.devices.front().station, QString());
}

} // namespace
} // namespace codewheel
