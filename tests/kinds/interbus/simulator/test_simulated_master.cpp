// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_refusals.h"
#include "tests/support/faulty_ring.h"

#include <algorithm>
#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

using testing::ElementsAre;

class ASimulatedMaster : public testing::Test
{
protected:
    ASimulatedMaster()
    {
        EXPECT_TRUE(m_ring.link->open());
        cycles(3);
    }
    const MasterStatus &status() const { return m_master.status(); }
    // As the runner does: data while the ring runs, otherwise none.
    void cycles(int count)
    {
        for (int i = 0; i < count; ++i) {
            m_in.resize(m_out.size());
            if (status().state != MasterState::run) {
                m_master.idleCycle();
            } else if (!m_ring.link->exchange(m_out, m_in)) {
                EXPECT_EQ(status().state, MasterState::busFail);
            }
        }
    }
    void cause(TrainingFault fault, NodeId place, int value = 1)
    {
        m_ring.ring->setFault(fault, place, value);
    }
    // Places that are out of the ring.
    std::vector<int> outOfRing() const
    {
        std::vector<int> out;
        for (std::size_t i = 0; i < status().devices.size(); ++i)
            if (!status().devices[i].inRing)
                out.push_back(static_cast<int>(i));
        return out;
    }
    void start()
    {
        ASSERT_TRUE(m_master.activateConfiguration());
        ASSERT_TRUE(m_master.startDataTransfer());
    }
    RingStructure readIn()
    {
        if (status().state == MasterState::run) {
            EXPECT_TRUE(m_master.stopDataTransfer());
        }
        if (status().state != MasterState::ready) {
            EXPECT_TRUE(m_master.deactivateConfiguration());
        }
        for (int i = 0; i < 100; ++i) {
            const auto cycle = m_master.createConfiguration();
            EXPECT_TRUE(cycle);
            if (!cycle || cycle->complete) {
                m_out.assign(cycle->found.size(), 0);
                return cycle->found;
            }
            EXPECT_EQ(cycle->found.size(), static_cast<std::size_t>(i) + 1);
        }
        ADD_FAILURE() << "never complete";
        return {};
    }

    FaultyRing m_ring;
    MasterLink &m_master = *m_ring.link->master();
    std::vector<Word> m_out = std::vector<Word>(FaultyRing::devices, 0);
    std::vector<Word> m_in;
};

TEST_F(ASimulatedMaster, IsHealthyInRunWith00E0)
{
    EXPECT_EQ(status().state, MasterState::run);
    EXPECT_EQ(status().statusBits, 0x00E0);
    EXPECT_EQ(status().parameter, 0x0000);
    EXPECT_EQ(status().errorCode, 0x0000);
    EXPECT_EQ(status().configurationName, QStringLiteral("plant.codewheel"));
    EXPECT_EQ(status().segments.size(), 6U);
}

TEST_F(ASimulatedMaster, GoesFromRunToReadyAndBackByItsServices)
{
    ASSERT_TRUE(m_master.stopDataTransfer());
    EXPECT_EQ(status().statusBits, 0x00C0);
    ASSERT_TRUE(m_master.deactivateConfiguration());
    EXPECT_EQ(status().statusBits, 0x0080);
    const auto active = m_master.activateConfiguration();
    ASSERT_TRUE(active);
    EXPECT_EQ(active->size(), FaultyRing::devices);
    EXPECT_EQ(status().statusBits, 0x00C0);
    ASSERT_TRUE(m_master.startDataTransfer());
    EXPECT_EQ(status().statusBits, 0x00E0);
}

TEST_F(ASimulatedMaster, RefusesServicesInTheWrongState)
{
    const auto isRefused = [](const auto &result) {
        return !result && result.error().id == RingRefusalId::masterStateWrong;
    };
    EXPECT_TRUE(isRefused(m_master.createConfiguration()));
    EXPECT_TRUE(isRefused(m_master.activateConfiguration()));
    EXPECT_TRUE(isRefused(m_master.deactivateConfiguration()));
    EXPECT_TRUE(isRefused(m_master.startDataTransfer()));
    ASSERT_TRUE(m_master.stopDataTransfer());
    EXPECT_TRUE(isRefused(m_master.stopDataTransfer()));
    ASSERT_TRUE(m_master.deactivateConfiguration());
    EXPECT_TRUE(isRefused(m_master.startDataTransfer()));
    EXPECT_TRUE(isRefused(m_master.switchSegment(2, false)));
    EXPECT_EQ(status().statusBits, 0x0080);
}

TEST_F(ASimulatedMaster, HoldsTheOutputsWhenStoppedAndZeroesThemAtAlarmStop)
{
    m_out[0] = 0x0200'00FF;
    cycles(3);
    ASSERT_TRUE(m_master.stopDataTransfer());
    cycles(5);
    EXPECT_EQ(m_ring.link->readBackOut()->front(), 0x0200'00FFU);
    m_master.alarmStop();
    cycles(1);
    EXPECT_EQ(status().statusBits, 0x0080);
    EXPECT_EQ(m_ring.link->readBackOut()->front(), 0U);
}

struct Broken
{
    TrainingFault fault;
    NodeId place;
    std::uint16_t code;
    std::uint16_t parameter;
    std::vector<int> outOfRing; // places
};
class ALocatedFault : public ASimulatedMaster, public testing::WithParamInterface<Broken>
{};

TEST_P(ALocatedFault, IsLookedForFoundAndGone)
{
    const Broken &broken = GetParam();
    m_out[0] = 0x0400'0001;
    cycles(2);
    cause(broken.fault, broken.place);
    cycles(1);
    EXPECT_EQ(status().state, MasterState::busFail);
    EXPECT_EQ(status().statusBits, 0x0090); // READY, DETECT
    EXPECT_EQ(status().errorCode, 0x0BDF);
    EXPECT_EQ(status().parameter, 0x0080);
    EXPECT_EQ(m_ring.link->readBackOut()->front(), 0U);
    cycles(SimulatedMaster::lookingCycles);
    EXPECT_EQ(status().statusBits, 0x0084); // READY, BUS
    EXPECT_EQ(status().errorCode, broken.code);
    EXPECT_EQ(status().parameter, broken.parameter);
    EXPECT_EQ(outOfRing(), broken.outOfRing);
    const auto refused = m_master.activateConfiguration();
    ASSERT_FALSE(refused);

    cause(broken.fault, broken.place, 0);
    cycles(1);
    EXPECT_EQ(status().state, MasterState::ready);
    EXPECT_EQ(status().errorCode, 0x0000);
    start();
    cycles(2);
    EXPECT_EQ(status().statusBits, 0x00E0);
    EXPECT_EQ(outOfRing(), std::vector<int>());
}

INSTANTIATE_TEST_SUITE_P(
    OfTheRing, ALocatedFault,
    testing::Values(
        // The outgoing remote bus of 1.0; everything after it on the main line.
        Broken{TrainingFault::wireBreak, NodeId("2.0"), 0x0D10, 0x0180, {1, 2, 3, 4, 5, 6, 7}},
        // Before the first device there is only the master
        Broken{TrainingFault::wireBreak, NodeId("1.0"), 0x0D10, 0x0100, {0, 1, 2, 3, 4, 5, 6, 7}},
        // The branch of the terminal, and within it
        Broken{TrainingFault::wireBreak, NodeId("4.0"), 0x0D10, 0x0381, {5, 6}},
        Broken{TrainingFault::wireBreak, NodeId("5.0"), 0x0D10, 0x0480, {6}},
        // After the branch, the main line continues from the terminal.
        Broken{TrainingFault::wireBreak, NodeId("6.0"), 0x0D10, 0x0380, {7}},
        // The local bus
        Broken{TrainingFault::wireBreak, NodeId("3.1"), 0x0D50, 0x0381, {3, 4}},
        Broken{TrainingFault::wireBreak, NodeId("3.2"), 0x0D50, 0x0302, {4}},
        Broken{TrainingFault::noSupply, NodeId("2.0"), 0x0C10, 0x0200, {1, 2, 3, 4, 5, 6, 7}},
        Broken{TrainingFault::noSupply, NodeId("3.2"), 0x0C10, 0x0302, {4}},
        Broken{TrainingFault::wrongDevice, NodeId("5.0"), 0x0C40, 0x0500, {6}},
        Broken{TrainingFault::wrongDevice, NodeId("3.1"), 0x0C40, 0x0301, {3, 4}}));

TEST_F(ASimulatedMaster, FindsNothingWhereTheFaultIsGoneAtTheCheck)
{
    cause(TrainingFault::wireBreak, NodeId("2.0"));
    cycles(1);
    cause(TrainingFault::wireBreak, NodeId("2.0"), 0);
    cycles(SimulatedMaster::lookingCycles);
    EXPECT_EQ(status().state, MasterState::busFail);
    EXPECT_EQ(status().errorCode, 0x0BE1);
    EXPECT_EQ(status().parameter, 0x0080);
    cycles(100);
    EXPECT_EQ(status().errorCode, 0x0BE1); // until a start or a confirmation
    start();
    EXPECT_EQ(status().statusBits, 0x00E0);
}

TEST_F(ASimulatedMaster, LooksAgainWhereAnotherFaultIsLeft)
{
    cause(TrainingFault::wireBreak, NodeId("2.0"));
    cause(TrainingFault::noSupply, NodeId("6.0"));
    cycles(1 + SimulatedMaster::lookingCycles);
    EXPECT_EQ(status().parameter, 0x0180);
    cause(TrainingFault::wireBreak, NodeId("2.0"), 0);
    cycles(1);
    EXPECT_EQ(status().errorCode, 0x0BDF);
    cycles(SimulatedMaster::lookingCycles);
    EXPECT_EQ(status().errorCode, 0x0C10);
    EXPECT_EQ(status().parameter, 0x0600);
}

TEST_F(ASimulatedMaster, RunsOnWithoutTheSegmentOfTheFault)
{
    cause(TrainingFault::wireBreak, NodeId("4.0"));
    cycles(1 + SimulatedMaster::lookingCycles);
    ASSERT_TRUE(m_master.switchSegment(4, false));
    start();
    cycles(3);
    EXPECT_EQ(status().statusBits, 0x01E0); // BSA
    EXPECT_THAT(outOfRing(), ElementsAre(5, 6));
    EXPECT_EQ(m_in[7], 6'000U);
    EXPECT_EQ(m_in[5], 0U);
    ASSERT_TRUE(m_master.switchSegment(4, true)); // still broken
    cycles(1);
    EXPECT_EQ(status().state, MasterState::busFail);
}

TEST_F(ASimulatedMaster, SwitchesOnlySegmentsItHas)
{
    const auto refused = m_master.switchSegment(9, false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(),
              (Refusal{RefusalKind::badInput,
                       RefusalId::unknownDevice,
                       {QStringLiteral("9.0"), QStringLiteral("1.0, 2.0, 3.0, 4.0, 5.0, 6.0")}}));
}

TEST_F(ASimulatedMaster, PeripheralFaultsStayUntilTheyAreConfirmedAndTheirCauseIsGone)
{
    cause(TrainingFault::peripheralFault, NodeId("3.1"));
    cycles(1);
    EXPECT_EQ(status().state, MasterState::run);
    EXPECT_EQ(status().statusBits, 0x00E2);
    EXPECT_EQ(status().errorCode, 0x0BB1);
    EXPECT_EQ(status().parameter, 0x0301);
    EXPECT_TRUE(status().devices[3].peripheralFault);
    ASSERT_TRUE(m_master.confirmDiagnostics());
    EXPECT_EQ(status().statusBits, 0x00E0);
    cycles(1); // the cause is still there
    EXPECT_EQ(status().errorCode, 0x0BB1);
    cause(TrainingFault::peripheralFault, NodeId("3.1"), 0);
    cycles(5);
    EXPECT_EQ(status().errorCode, 0x0BB1); // not by itself
    ASSERT_TRUE(m_master.confirmDiagnostics());
    cycles(5);
    EXPECT_EQ(status().statusBits, 0x00E0);
    EXPECT_EQ(status().parameter, 0x0000);
}

// Only 0760 clears a report, whatever else is done with the configuration.
TEST_F(ASimulatedMaster, PeripheralFaultsStayWhenTheRingIsReadInAgain)
{
    cause(TrainingFault::peripheralFault, NodeId("6.0"));
    cycles(1);
    cause(TrainingFault::peripheralFault, NodeId("6.0"), 0);
    readIn();
    EXPECT_EQ(status().statusBits, 0x00C2);
    EXPECT_EQ(status().parameter, 0x0600);
    ASSERT_TRUE(m_master.keepConfiguration({QStringLiteral("same.codewheel"), *m_ring.link->open()}));
    m_master.alarmStop();
    start();
    EXPECT_EQ(status().statusBits, 0x00E2);
    cause(TrainingFault::wireBreak, NodeId("4.0")); // the segments after it move up
    readIn();
    EXPECT_EQ(status().parameter, 0x0400);
    ASSERT_TRUE(m_master.confirmDiagnostics());
    EXPECT_EQ(status().statusBits, 0x00C0);
}

TEST_F(ASimulatedMaster, APeripheralFaultGoesWithItsDevice)
{
    cause(TrainingFault::peripheralFault, NodeId("2.0"));
    cycles(1);
    cause(TrainingFault::peripheralFault, NodeId("2.0"), 0);
    cause(TrainingFault::wrongDevice, NodeId("2.0"));
    cycles(30);
    readIn();
    EXPECT_EQ(status().statusBits, 0x00C0);
}

TEST_F(ASimulatedMaster, CountsCrcErrorsBySegmentAndKeepsTheWordsOfTheCycleBefore)
{
    cause(TrainingFault::crcErrors, NodeId("2.0"), 100);
    cycles(1'000);
    const std::uint32_t errors = status().segments[1].crcErrors;
    EXPECT_GT(errors, 60U);
    EXPECT_LT(errors, 140U);
    EXPECT_EQ(status().segments[0].crcErrors, 0U);
    EXPECT_EQ(status().statusBits, 0x40E0); // QUALITY
    EXPECT_EQ(m_in[0], 1'000U);
    cause(TrainingFault::crcErrors, NodeId("2.0"), 0);
    ASSERT_TRUE(m_master.confirmDiagnostics());
    EXPECT_EQ(status().statusBits, 0x00E0);
    EXPECT_EQ(status().segments[1].crcErrors, errors);
    ASSERT_TRUE(m_master.stopDataTransfer());
    ASSERT_TRUE(m_master.startDataTransfer());
    EXPECT_EQ(status().segments[1].crcErrors, 0U);
}

TEST_F(ASimulatedMaster, FindsTheSameRingDeviceByDevice)
{
    const RingStructure before = *m_ring.link->open();
    const RingStructure found = readIn();
    EXPECT_TRUE(isSameRing(found, before));
    EXPECT_TRUE(std::ranges::all_of(found, [](const RingDevice &p) { return p.deviceKey.isEmpty(); }));
    EXPECT_EQ(status().state, MasterState::active);
}

TEST_F(ASimulatedMaster, CountsSegmentsAnewWhereDevicesAreMissing)
{
    cause(TrainingFault::wireBreak, NodeId("4.0"));
    const RingStructure found = readIn();
    std::vector<NodeId> numbers;
    for (const RingDevice &participant : found)
        numbers.push_back(participant.number);
    EXPECT_THAT(numbers, ElementsAre(NodeId("1.0"), NodeId("2.0"), NodeId("3.0"), NodeId("3.1"),
                                     NodeId("3.2"), NodeId("4.0")));
    ASSERT_TRUE(m_master.startDataTransfer());
    cycles(3);
    EXPECT_EQ(m_in[5], 6'000U); // 6.0 of the whole ring
    cause(TrainingFault::wireBreak, NodeId("4.0"), 0);
    cycles(3);
    EXPECT_EQ(status().statusBits, 0x00E0);
    EXPECT_EQ(readIn().size(), FaultyRing::devices);
}

TEST_F(ASimulatedMaster, FindsTheWrongDevice)
{
    cause(TrainingFault::wrongDevice, NodeId("2.0"));
    cycles(30);
    const RingStructure found = readIn();
    EXPECT_EQ(found[1].deviceCode, 0x0236U);
    EXPECT_EQ(found[1].outWords, 0);
    ASSERT_TRUE(m_master.startDataTransfer());
    cycles(3);
    EXPECT_EQ(m_in[1], 4'096U);
}

TEST_F(ASimulatedMaster, KeepsAConfigurationOverADisconnect)
{
    KeptConfiguration other{QStringLiteral("other.codewheel"), *m_ring.link->open()};
    other.structure.pop_back();
    ASSERT_TRUE(m_master.keepConfiguration(other));
    m_ring.link->close();
    m_ring.link = std::make_unique<SimulatedRingLink>(m_ring.ring);
    ASSERT_TRUE(m_ring.link->open());
    EXPECT_EQ(m_ring.link->master()->keptConfiguration(), other);
    EXPECT_EQ(m_ring.link->master()->status().configurationName, QStringLiteral("other.codewheel"));
}

TEST_F(ASimulatedMaster, DoesNotActivateWhatTheRingIsNot)
{
    KeptConfiguration other{QStringLiteral("other.codewheel"), *m_ring.link->open()};
    other.structure[1].deviceCode = 0x0236;
    ASSERT_TRUE(m_master.keepConfiguration(other));
    EXPECT_EQ(status().statusBits, 0x00E0); // the active part is left alone
    m_master.alarmStop();
    const auto refused = m_master.activateConfiguration();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(),
              (Refusal{RefusalKind::link,
                       RefusalId::ringDiffers,
                       {QStringLiteral("2.0"), QStringLiteral("0236h"), QStringLiteral("0237h")}}));
    EXPECT_EQ(readIn().size(), FaultyRing::devices);
}

// Whatever happens to the ring and whatever is requested: the state is one of four, with the bits that belong
// to it, and READY, 0711, 0701 leads to RUN once everything is repaired.
TEST_F(ASimulatedMaster, RandomFaultsAndServicesLeaveNoStateThatIsNotDocumented)
{
    std::mt19937 random{4}; // NOLINT: the same in each run
    const auto below = [&](std::size_t limit) { return static_cast<int>(random() % limit); };
    const RingStructure plan = *m_ring.link->open();
    const std::array<TrainingFault, 5> faults{TrainingFault::wireBreak, TrainingFault::crcErrors,
                                              TrainingFault::noSupply, TrainingFault::wrongDevice,
                                              TrainingFault::peripheralFault};
    for (int round = 0; round < 20'000; ++round) {
        const NodeId place = plan[static_cast<std::size_t>(below(plan.size()))].number;
        switch (below(12)) {
        case 0:
        case 1:
            cause(faults.at(static_cast<std::size_t>(below(faults.size()))), place, below(2));
            break;
        case 2:
            for (const TrainingFault fault : faults)
                cause(fault, place, 0);
            break;
        case 3:
            std::ignore = m_master.activateConfiguration();
            break;
        case 4:
            std::ignore = m_master.startDataTransfer();
            break;
        case 5:
            std::ignore = m_master.stopDataTransfer();
            break;
        case 6:
            std::ignore = m_master.switchSegment(below(8), below(3) > 0);
            break;
        case 7:
            std::ignore = m_master.confirmDiagnostics();
            break;
        case 8:
            if (below(4) == 0)
                m_master.alarmStop();
            break;
        case 9:
            std::ignore = m_master.deactivateConfiguration();
            break;
        case 10:
            std::ignore = m_master.createConfiguration();
            break;
        default:
            break;
        }
        m_out.assign(m_ring.link->open()->size(), 0);
        cycles(1 + below(30));

        const unsigned ofState = status().statusBits & 0x00F4U;
        const bool looking = status().errorCode == 0x0BDF;
        const unsigned expected = status().state == MasterState::run      ? 0x00E0U
                                  : status().state == MasterState::active ? 0x00C0U
                                  : status().state == MasterState::ready  ? 0x0080U
                                  : looking                               ? 0x0090U
                                                                          : 0x0084U;
        ASSERT_EQ(ofState, expected) << "round " << round;
        ASSERT_EQ(status().state == MasterState::busFail || (status().statusBits & 0x0002) != 0,
                  status().errorCode != 0)
            << "round " << round;
        ASSERT_EQ(status().devices.size(), m_out.size()) << "round " << round;
    }
    for (const RingDevice &participant : plan)
        for (const TrainingFault fault : faults)
            cause(fault, participant.number, 0);
    cycles(50);
    EXPECT_EQ(readIn().size(), FaultyRing::devices);
    ASSERT_TRUE(m_master.startDataTransfer());
    ASSERT_TRUE(m_master.confirmDiagnostics());
    cycles(3);
    EXPECT_EQ(status().statusBits, 0x00E0);
}

} // namespace
} // namespace codewheel
