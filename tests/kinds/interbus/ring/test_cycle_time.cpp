// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/cycle_time.h"
#include "kinds/interbus/words/device_number.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

RingStructure encoders(int count)
{
    RingStructure structure;
    for (int i = 1; i <= count; ++i)
        structure.push_back({DeviceNumber{i, 0}.node(), 0x0237, 2, 2, {}});
    return structure;
}

TEST(CycleTime, OneK3EncoderAt500kBd)
{
    const RingLoad load = ringLoad(encoders(1));
    EXPECT_NEAR(cycleTime(load, bitAt500kBd, CycleTimeForm::g3).count(), 463, 0.5);
    EXPECT_NEAR(cycleTime(load, bitAt500kBd, CycleTimeForm::g4).count(), 1007, 0.5);
}

TEST(CycleTime, AllThat4096PointsAllowAt2MBd)
{
    const RingLoad load = ringLoad(encoders(128));
    EXPECT_NEAR(cycleTime(load, bitAt2MBd, CycleTimeForm::g3).count(), 3700, 50);
    EXPECT_NEAR(cycleTime(load, bitAt2MBd, CycleTimeForm::g4).count(), 4800, 50);
}

TEST(CycleTime, G4GivesThePublishedFigureFor4096Points)
{
    EXPECT_NEAR(cycleTime({512, 1, 0}, bitAt500kBd, CycleTimeForm::g4).count(), 16200, 50);
}

TEST(CycleTime, CableTakes16MicrosecondsAKilometre)
{
    const RingStructure structure = encoders(1);
    const auto difference = cycleTime(ringLoad(structure, 12.5), bitAt500kBd, CycleTimeForm::g3) -
                            cycleTime(ringLoad(structure), bitAt500kBd, CycleTimeForm::g3);
    EXPECT_NEAR(difference.count(), 200, 1e-6);
}

TEST(CycleTime, WiderDirectionCountsAndLocalDevicesAreNoRemoteBusDevices)
{
    const RingStructure structure{{NodeId("1.0"), 0x0136, 1, 0, {}}, {NodeId("1.1"), 0x02B3, 2, 2, {}}};
    const RingLoad load = ringLoad(structure);
    EXPECT_EQ(load.dataBytes, 6);
    EXPECT_EQ(load.remoteBusDevices, 1);
}

} // namespace
} // namespace codewheel
