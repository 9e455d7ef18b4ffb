// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/check_project.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/plans.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

Project encoders(int count)
{
    Project project;
    for (int segment = 1; segment <= count; ++segment) {
        ProjectDevice device;
        device.participant = RingDevice{DeviceNumber{segment, 0}.node(), 0x0237, 2, 2, {}};
        project.devices.push_back(device);
    }
    return project;
}

QStringList findings(const Project &project)
{
    QStringList texts;
    for (const Finding &finding : checkProject(project, processAddresses(project)))
        texts << QStringLiteral("%1 %2: %3")
                     .arg(finding.device)
                     .arg(finding.severity == Severity::fault ? QStringLiteral("fault")
                                                              : QStringLiteral("attention"),
                          finding.text);
    return texts;
}

TEST(CheckProject, NothingIsSaidOfAPlanInOrder)
{
    EXPECT_EQ(findings(encoders(128)), QStringList());
    EXPECT_EQ(findings({}), QStringList());
}

TEST(CheckProject, OverlapsAreToldAtBothDevices)
{
    Project project = encoders(3);
    project.devices[0].set(GivenAddresses{.in = 10});
    project.devices[2].set(GivenAddresses{.in = 12});
    EXPECT_EQ(findings(project), (QStringList{QStringLiteral("0 fault: IN at 10 overlaps that of 3.0."),
                                              QStringLiteral("2 fault: IN at 12 overlaps that of 1.0.")}));
    changeRing(project, [&](RingPlan &ring) { ring.addresses.unit = AddressRules::Unit::word; });
    EXPECT_EQ(findings(project).first(), QStringLiteral("0 fault: IN at 5 overlaps that of 3.0."));
    project.devices[2].set(GivenAddresses{.in = 14});
    EXPECT_EQ(findings(project), QStringList()) << "side by side";
}

TEST(CheckProject, OneLongRangeOverlapsSeveral)
{
    Project project = encoders(3);
    RingDevice wide = ringDevice(project.devices[0].participant);
    wide.outWords = 8;
    project.devices[0].participant = wide;
    for (ProjectDevice &device : project.devices)
        device.set(GivenAddresses{.out = 0});
    project.devices[2].set(GivenAddresses{.out = 14});
    EXPECT_EQ(findings(project).size(), 4);
    EXPECT_TRUE(findings(project).contains(QStringLiteral("2 fault: OUT at 14 overlaps that of 1.0.")));
}

TEST(CheckProject, AnOddByteIsWithinAWord)
{
    Project project = encoders(1);
    project.devices[0].set(GivenAddresses{.out = 13});
    EXPECT_EQ(findings(project),
              QStringList{QStringLiteral("0 attention: OUT begins at the odd byte 13, within a word.")});
}

// FRABA manual 4: with a Step 5 PLC the encoder must be above P127.
TEST(CheckProject, Step5WantsEncodersAboveP127)
{
    Project project = encoders(1);
    ProjectDevice input;
    input.participant = RingDevice{NodeId("2.0"), 0x0102, 1, 0, {}};
    project.devices.push_back(input);
    EXPECT_EQ(findings(project), QStringList()) << "it is switched off";
    changeRing(project, [&](RingPlan &ring) { ring.addresses.step5 = true; });
    EXPECT_EQ(
        findings(project),
        (QStringList{QStringLiteral(
                         "0 attention: IN is not above P127: with Step 5, the process image overwrites it."),
                     QStringLiteral("0 attention: OUT is not above P127: with Step 5, the process image "
                                    "overwrites it.")}));
    project.devices[0].set(GivenAddresses{.in = 127, .out = 128});
    EXPECT_EQ(findings(project).size(), 2) << "127 is odd as well";
    project.devices[0].set(GivenAddresses{.in = 128, .out = 128});
    EXPECT_EQ(findings(project), QStringList());
}

TEST(CheckProject, ALoop2EncoderStandsOnALocalBus)
{
    Project project = encoders(1);
    project.devices[0].participant = RingDevice{NodeId("1.0"), 0x000C, 0, 0, {}};
    ProjectDevice loop2;
    loop2.participant = RingDevice{NodeId("1.1"), 0x02B3, 2, 2, {}};
    project.devices.push_back(loop2);
    EXPECT_EQ(findings(project), QStringList());
    project.devices[1].participant.number = NodeId("2.0");
    EXPECT_EQ(findings(project),
              (QStringList{QStringLiteral(
                  "1 attention: Devices with this ID code belong on the local bus of a bus terminal.")}));
}

TEST(CheckProject, LimitsOfTheRingAreFaults)
{
    const QStringList found = findings(encoders(129));
    EXPECT_EQ(found,
              (QStringList{QStringLiteral("128 fault: A ring has at most 4096 inputs; these are 4128."),
                           QStringLiteral("128 fault: A ring has at most 4096 outputs; these are 4128.")}));
}

} // namespace
} // namespace codewheel
