// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault that a plan can cause has a sentence that says where it is and what to do.
#include "bus/bus_faults.h"
#include "bus/bus_outline.h"
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct PlannedFault
{
    TrainingFault fault;
    Place place;
    const char *text; // its beginning
    const char *code = "";
    std::vector<FaultAction> actions{};
    std::vector<Word> words{}; // that reveal the fault
    int value = 1;
};

const std::vector<PlannedFault> plannedFaults{
    {TrainingFault::wireBreak,
     "4.0"_ring,
     "The cable between 3.0 and 4.0 is interrupted, or 4.0 has no supply. Check plug, shield and 24 V.",
     "0D10 at outgoing remote bus of 3.0 (see IBS SYS FW G4 UM)",
     {FaultAction::start, FaultAction::switchOff}},
    {TrainingFault::wireBreak,
     "6.1"_ring,
     "The cable between 6.0 and 6.1 is interrupted, or 6.1 has no supply. Check plug, shield and 24 V.",
     "0D50 at outgoing local bus of 6.0 (see IBS SYS FW G4 UM)",
     {FaultAction::start, FaultAction::switchOff}},
    {TrainingFault::wireBreak,
     "1.0"_ring,
     "1.0 is not found as configured: it has no supply, the cable between the master and 1.0 is interrupted, "
     "or another device is there. Check 24 V, plug, and which device it is.",
     "0D10 at 1.0 (see IBS SYS FW G4 UM)",
     {FaultAction::start}},
    {TrainingFault::noSupply,
     "2.0"_ring,
     "2.0 is not found as configured: it has no supply, the cable between 1.0 and 2.0 is interrupted, or "
     "another device is there. Check 24 V, plug, and which device it is.",
     "0C10 at 2.0 (see IBS SYS FW G4 UM)",
     {FaultAction::start, FaultAction::switchOff}},
    {TrainingFault::wrongDevice,
     "5.0"_ring,
     "5.0 is not found as configured: it has no supply, the cable between 4.0 and 5.0 is interrupted, or "
     "another device is there. Check 24 V, plug, and which device it is.",
     "0C40 at 5.0 (see IBS SYS FW G4 UM)",
     {FaultAction::start, FaultAction::switchOff}},
    {TrainingFault::crcErrors,
     "3.0"_ring,
     "Many data cycles are faulty: ",
     "",
     {FaultAction::confirm},
     {},
     100},
    {TrainingFault::peripheralFault,
     "3.0"_ring,
     "3.0 reports a fault of its periphery, and the ring runs on. Check what is connected to it, and its "
     "supply; then confirm.",
     "0BB1 – peripheral fault at 3.0",
     {FaultAction::confirm}},
    {TrainingFault::powerOff, "2.0"_ring,
     "IN of 2.0 fell to 00000000: the encoder has no supply, or is at position 0. Check its supply, or "
     "turn the shaft to see it change."},
    {TrainingFault::slowConfirmation,
     "2.0"_ring,
     "2.0 takes long to confirm OUT 020000FF, or does not know the word. Wait; if nothing comes, check which "
     "encoder it is, and switch it off and on.",
     "",
     {},
     {0x0200'00FF}},
    {TrainingFault::slowConfirmation,
     "5.0"_ring,
     "5.0 takes long to confirm OUT 88000000",
     "",
     {},
     {0x0800'0000, 0x8800'0000}},
    {TrainingFault::eepromWornOut,
     "2.0"_ring,
     "2.0: Error 13: the encoder could not store its parameters (IN 9A000000). Write them again; if the "
     "error "
     "comes back, replace the encoder.",
     "",
     {},
     {0x0200'00FF, 0x8000'0000}},
    {TrainingFault::parametersLost, "1.0"_ring,
     "1.0: Error 3: the encoder has lost its parameters (IN 86000000). Write parameters 1 to 4 again, or "
     "reset it to factory settings."},
    {TrainingFault::batteryLow, "2.0"_ring,
     "2.0: Error 14: the battery of the encoder is low (IN 9C000000). Have it replaced; run brings the "
     "encoder back to operation."},
    {TrainingFault::codeDiscFault, "2.0"_ring,
     "2.0: Error 15: the encoder reads a faulty value from its code disc (IN 9E000000). Send run; if the "
     "error comes back, replace the encoder."},
    {TrainingFault::camOutOfRange, "1.0"_ring,
     "1.0: Error 98000004: a start or stop of a cam is above the largest position (IN 98000004). Compare the "
     "cam programs with the total range."},
    {TrainingFault::magnetLost, "5.0"_ring, "5.0: The magnet is outside the measuring range (IN "},
};

class FaultSentences : public testing::TestWithParam<PlannedFault>
{
protected:
    FaultSentences()
    {
        EXPECT_TRUE(bus.open(RingSession::Start::operating));
        bus.advance(10);
    }

    void befall(const PlannedFault &planned)
    {
        training.controls->setFault(planned.fault, planned.place.node, planned.value);
        if (planned.fault == TrainingFault::batteryLow)
            training.controls->powerCycle(planned.place.node);
        for (const Word word : planned.words) {
            bus.channel(planned.place)->stage(word);
            EXPECT_TRUE(bus.channel(planned.place)->write());
            frames(planned.fault == TrainingFault::slowConfirmation ? 330 : 700);
        }
        frames(planned.fault == TrainingFault::slowConfirmation ? 0 : 700);
    }
    void frames(int milliseconds) // as taken by the window
    {
        for (int i = 0; i < milliseconds; i += 33)
            bus.advance(33);
    }
    std::vector<Fault> faults() const { return bus.outline().faults(); }
    NodeState state(Place place) const
    {
        const std::vector<BusNode> nodes = bus.outline().nodes();
        const auto node = std::ranges::find(nodes, place.node, &BusNode::node);
        return bus.outline().state(static_cast<std::size_t>(node - nodes.begin()));
    }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
};

TEST_P(FaultSentences, SayWhatIsWrongWhereAndWhatToDo)
{
    EXPECT_TRUE(faults().empty());
    befall(GetParam());
    ASSERT_EQ(faults().size(), 1U);
    const Fault fault = faults().front();
    EXPECT_TRUE(fault.text.startsWith(QLatin1String(GetParam().text))) << fault.text.toStdString();
    EXPECT_EQ(fault.code.toStdString(), GetParam().code);
    EXPECT_EQ(fault.actions, GetParam().actions);
    EXPECT_EQ(fault.node, GetParam().place.node);
    EXPECT_NE(fault.shown.role, Role::running);
    EXPECT_LE(fault.shown.word.size(), 12) << "the tree has room for a word";
}

INSTANTIATE_TEST_SUITE_P(OfAllThatAPlanCauses, FaultSentences, testing::ValuesIn(plannedFaults));

TEST(TheTableOfFaults, HasAllThatAPlanCanCause)
{
    for (int fault = 0; fault < trainingFaults; ++fault)
        EXPECT_GT(std::ranges::count(plannedFaults, static_cast<TrainingFault>(fault), &PlannedFault::fault),
                  0)
            << trainingFaultKey(static_cast<TrainingFault>(fault)).toStdString();
}

class FaultOfRing : public FaultSentences
{};

TEST_F(FaultOfRing, WhatLiesBehindABreakIsCutOff)
{
    befall({TrainingFault::wireBreak, "4.0"_ring, ""});
    EXPECT_FALSE(state("3.0"_ring).isCutOff);
    EXPECT_TRUE(state("4.0"_ring).isCutOff);
    EXPECT_TRUE(state("4.0"_ring).isBehindBreak);
    EXPECT_TRUE(state("6.1"_ring).isCutOff);
    EXPECT_FALSE(state("6.1"_ring).isBehindBreak);
    EXPECT_EQ(state("4.0"_ring).shown.word, QStringLiteral("cut off"));
    EXPECT_EQ(bus.outline().state().word, QStringLiteral("BUS FAIL"));
    bus.switchSegment(4, false);
    frames(100);
    EXPECT_EQ(state("4.0"_ring).shown.word, QStringLiteral("off"));
    EXPECT_FALSE(state("4.0"_ring).isBehindBreak);
}

TEST_F(FaultOfRing, IsToldUntilTheBusRunsAgain)
{
    Buses buses;
    buses.add(bus);
    BusFaults all;
    EXPECT_TRUE(all.look(buses).empty());
    const PlannedFault broken{TrainingFault::wireBreak, "4.0"_ring, ""};
    befall(broken);
    ASSERT_EQ(all.look(buses).size(), 1U);
    EXPECT_EQ(all.all().front().bus, firstBus);
    EXPECT_TRUE(all.all().front().fault.text.startsWith(QStringLiteral("The cable")));
    training.controls->setFault(broken.fault, broken.place.node, 0);
    frames(100);
    ASSERT_EQ(all.look(buses).size(), 1U);
    EXPECT_EQ(all.all().front().fault.text,
              QStringLiteral("The fault is not told any more, but the bus is stopped. Start it again."));
    EXPECT_EQ(all.all().front().fault.actions, std::vector{FaultAction::start});
    bus.setRunning(true);
    frames(100);
    EXPECT_TRUE(all.look(buses).empty());
    bus.setRunning(false);
    frames(100);
    EXPECT_TRUE(all.look(buses).empty()) << "whoever stopped it knows";
}

TEST_F(FaultOfRing, TheOneThatStopsTheBusComesFirst)
{
    Buses buses;
    buses.add(bus);
    BusFaults all;
    befall({TrainingFault::crcErrors, "2.0"_ring, "", "", {}, {}, 100});
    befall({TrainingFault::parametersLost, "1.0"_ring, ""});
    all.look(buses);
    ASSERT_EQ(all.all().size(), 2U);
    EXPECT_EQ(all.all().front().fault.shown.word, QStringLiteral("error 3"));
    befall({TrainingFault::wireBreak, "6.0"_ring, ""});
    all.look(buses);
    EXPECT_EQ(all.all().front().fault.extent, Fault::Extent::standstill);
    bus.close();
    EXPECT_TRUE(all.look(buses).empty()) << "nobody knows any more";
}

TEST_F(FaultOfRing, AnEncoderThatIsSetToZeroIsNoneWithoutPower)
{
    const Place baumer = "2.0"_ring;
    training.controls->setSpeed(baumer.node, 0);
    training.controls->turnTo(baumer.node, 400'000);
    frames(100);
    EXPECT_NE(bus.channel(baumer)->in(), 0U);
    bus.channel(baumer)->stage(0x4000'0000);
    EXPECT_TRUE(bus.channel(baumer)->write());
    frames(300);
    EXPECT_EQ(bus.channel(baumer)->in(), 0U) << "the preset is 0";
    EXPECT_TRUE(faults().empty());
}

} // namespace
} // namespace codewheel
