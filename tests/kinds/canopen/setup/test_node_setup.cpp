// SPDX-License-Identifier: GPL-3.0-or-later
// A device on a bus gets its number and rate, and is looked for afterwards.
#include "kinds/canopen/setup/lss_search.h"
#include "kinds/canopen/setup/node_check.h"
#include "kinds/canopen/setup/node_setup.h"
#include "kinds/canopen/setup/node_task_run.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::IdentityReading;
using canopen::LssSearch;
using canopen::LssSelection;
using canopen::NodeCheck;
using canopen::NodeIdentity;
using canopen::NodeSetup;
using canopen::NodeSetupWish;
using SetupStep = NodeSetup::Step;
using Trouble = NodeSetup::Trouble;
using Fate = NodeSetup::Fate;

// As the training plant tells it.
constexpr NodeIdentity identityOfSix{{0x10D, 0x25, 0x10001, 0x0012'D5A4}};
constexpr NodeIdentity identityOfUnnumbered{{0x10D, 0x25, 0x10001, 0x0013'0015}};
constexpr std::size_t encoderSix = 1;

class NodeSetupOnBus : public test::CanopenPlant
{
protected:
    NodeSetupOnBus() { run.setBus(bus.get()); }

    void connectAnew(const std::vector<canopen::CanopenEncoderPlan> &encoders)
    {
        run.setBus(nullptr);
        connectTo(encoders);
        run.setBus(bus.get());
    }
    void carryOut(canopen::NodeTask &task, Instant within = 60s)
    {
        run.start(task);
        for (Instant passed{}; run.isRunning() && passed < within; passed += 20ms)
            bus->advance(20ms);
        EXPECT_FALSE(run.isRunning());
    }
    // The device of node 6 is to get this number.
    static NodeSetupWish toNode(int node)
    {
        return {.identity = identityOfSix, .nodeBefore = 6, .node = node};
    }
    NodeCheck check(int node, Instant within = 60s)
    {
        NodeCheck task({.node = node,
                        .identity = identityOfSix,
                        .nodeBefore = 6,
                        .before = canopen::BootUps::of(bus->latest(), node)});
        carryOut(task, within);
        return task;
    }
    void switchOffAndOn(std::size_t which)
    {
        for (const bool isOn : {false, true}) {
            plant->withEncoder(which, [isOn](canopen::SimulatedNode &node) { node.setOn(isOn); });
            bus->advance(500ms);
        }
    }
    std::optional<int> numberOf(std::size_t which)
    {
        return plant->withEncoder(which, [](canopen::SimulatedNode &node) { return node.node(); });
    }
    // Frames of LSS with this command.
    int lssSent(std::uint8_t command) const
    {
        return static_cast<int>(std::ranges::count_if(link->sent, [command](const CanFrame &frame) {
            return frame.id == 0x7E5 && frame.bytes[0] == command;
        }));
    }

    NodeTaskRun run;
};

TEST_F(NodeSetupOnBus, TheIdentityOfANodeIsRead)
{
    operate();
    IdentityReading reading(6);
    carryOut(reading);
    EXPECT_EQ(reading.result(), IdentityReading::Result::read);
    EXPECT_EQ(reading.identity(), identityOfSix);
    IdentityReading nobody(77);
    carryOut(nobody);
    EXPECT_EQ(nobody.result(), IdentityReading::Result::noAnswer);
}

TEST_F(NodeSetupOnBus, ANodeHasItsNewNumberAfterTheResetAndKeepsItWithoutSupply)
{
    operate();
    NodeSetup setup(toNode(9));
    EXPECT_EQ(setup.steps(), (std::vector{SetupStep::free, SetupStep::select, SetupStep::node,
                                          SetupStep::store, SetupStep::leave, SetupStep::reset}));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    EXPECT_EQ(setup.node(), Fate::done);
    EXPECT_EQ(setup.store(), Fate::done);
    EXPECT_TRUE(setup.isReset());
    EXPECT_EQ(check(9).result(), NodeCheck::Result::found);
    const auto before = canopen::BootUps::of(bus->latest(), 9);
    bus->advance(2s);
    switchOffAndOn(encoderSix);
    NodeCheck proof({.node = 9, .identity = identityOfSix, .nodeBefore = 6, .before = before});
    carryOut(proof);
    EXPECT_EQ(proof.result(), NodeCheck::Result::found);
    EXPECT_TRUE(proof.wasWithoutSupply());
    EXPECT_FALSE(proof.wasOnlyReset());
    EXPECT_EQ(numberOf(encoderSix), 9);
}

TEST_F(NodeSetupOnBus, WithoutSupplyBeingSwitchedNoBootUpIsHeard)
{
    operate();
    const NodeCheck proof = check(6);
    EXPECT_EQ(proof.result(), NodeCheck::Result::found);
    EXPECT_FALSE(proof.wasWithoutSupply());
    EXPECT_FALSE(proof.wasOnlyReset());
}

// Whoever has asked for it, and whether the node itself or all were told to.
TEST_F(NodeSetupOnBus, AResetIsNoProofThatItsSupplyWasOff)
{
    operate();
    const auto before = canopen::BootUps::of(bus->latest(), 6);
    const auto proof = [&] {
        NodeCheck task({.node = 6, .identity = identityOfSix, .nodeBefore = 6, .before = before});
        carryOut(task);
        EXPECT_EQ(task.result(), NodeCheck::Result::found);
        return task;
    };
    bus->send(canopen::NmtRequest{canopen::NmtCommand::resetNode, 6}.frame());
    bus->advance(3s);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::resetCommunication, 0}.frame());
    bus->advance(3s);
    bus->sendBesideOthers();
    say(canopen::NmtRequest{canopen::NmtCommand::resetNode, 6}.frame());
    bus->advance(3s);
    EXPECT_EQ(canopen::BootUps::of(bus->latest(), 6).all, before.all + 3);
    EXPECT_FALSE(proof().wasWithoutSupply());
    EXPECT_TRUE(proof().wasOnlyReset());
    switchOffAndOn(encoderSix);
    EXPECT_TRUE(proof().wasWithoutSupply());
}

TEST_F(NodeSetupOnBus, ANumberThatAnotherNodeHasIsNotGiven)
{
    operate();
    NodeSetup setup(toNode(7));
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::numberTaken);
    EXPECT_TRUE(setup.isUntouched());
    EXPECT_EQ(sentTo(0x7E5), 0);
}

// It tells of itself, and answers nothing while it is stopped.
TEST_F(NodeSetupOnBus, ANumberThatIsHeardIsNotGiven)
{
    operate();
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 7}.frame());
    bus->advance(1500ms);
    NodeSetup setup(toNode(7));
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::numberTaken);
}

// One without heartbeat is stopped in silence.
TEST_F(NodeSetupOnBus, TheNumberOfANodeThatWasStoppedIsNotGivenUntilItWasStartedAgain)
{
    operate();
    bus->transfer({.node = 7, .object = {0x1017, 0}, .value = std::vector<std::uint8_t>{0, 0}});
    bus->advance(200ms);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 7}.frame());
    bus->advance(20s);
    const auto troubleWithSeven = [this] {
        NodeSetup setup(toNode(7));
        carryOut(setup);
        return setup.trouble();
    };
    EXPECT_EQ(troubleWithSeven(), Trouble::numberStopped);
    EXPECT_EQ(sentTo(0x7E5), 0);
    link->isGone = true; // the bus goes on meanwhile
    bus->advance(1s);
    link->isGone = false;
    bus->advance(3s);
    bus->setOperate(true);
    bus->advance(1s);
    EXPECT_EQ(troubleWithSeven(), Trouble::numberStopped);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 7}.frame());
    bus->advance(20s);
    EXPECT_EQ(troubleWithSeven(), Trouble::numberTaken);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 7}.frame());
    bus->advance(20s);
    plant->withEncoder(2, [](canopen::SimulatedNode &node) { node.setOn(false); });
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 7}.frame());
    bus->advance(20s);
    EXPECT_FALSE(troubleWithSeven());
}

TEST_F(NodeSetupOnBus, OfTwoWithTheSameNumberTheOneThatWasReadIsMeant)
{
    auto encoders = canopen::trainingEncoders();
    encoders[0].node = 6; // like the next one
    connectAnew(encoders);
    open(EncoderBus::Start::watching);
    ASSERT_TRUE(bus->remove(six)); // their answers to the same question would disturb each other
    bus->setOperate(true);
    bus->advance(1s);
    NodeSetup setup(toNode(9));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    bus->advance(1s);
    EXPECT_EQ(numberOf(encoderSix), 9);
    EXPECT_EQ(numberOf(0), 6);
}

TEST_F(NodeSetupOnBus, AnotherDeviceThanTheOneThatWasReadIsNotWrittenTo)
{
    operate();
    NodeSetupWish wish = toNode(9);
    wish.identity.words[3] += 1;
    NodeSetup setup(wish);
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::nobody);
    EXPECT_TRUE(setup.isUntouched());
    EXPECT_FALSE(setup.mayStayInConfiguration());
    EXPECT_EQ(lssSent(0x11), 0);
}

// Two of the same identity: nobody can say which of them would take the number.
TEST_F(NodeSetupOnBus, WhatSeveralWouldTakeIsNotWritten)
{
    auto encoders = canopen::trainingEncoders();
    encoders.push_back(encoders[1]);
    encoders.back().node = 30;
    connectAnew(encoders);
    operate();
    NodeSetup setup(toNode(9));
    carryOut(setup);
    EXPECT_TRUE(setup.trouble() == Trouble::several || setup.trouble() == Trouble::identityNotTold);
    EXPECT_TRUE(setup.isUntouched());
    EXPECT_EQ(lssSent(0x11), 0);
}

TEST_F(NodeSetupOnBus, ALinkThatIsLostJustBehindTheStoreLeavesItInDoubt)
{
    operate();
    link->goneAfter = [](const CanFrame &frame) { return frame.id == 0x7E5 && frame.bytes[0] == 0x17; };
    NodeSetup setup(toNode(9));
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::noAnswer);
    EXPECT_EQ(setup.node(), Fate::done);
    EXPECT_EQ(setup.store(), Fate::notKnown);
    EXPECT_TRUE(setup.mayStayInConfiguration());
    EXPECT_FALSE(setup.isReset());
    EXPECT_EQ(lssSent(0x17), 1);
}

TEST_F(NodeSetupOnBus, ABusThatIsClosedMeanwhileEndsItWithWhatIsKnown)
{
    operate();
    NodeSetup setup(toNode(9));
    run.start(setup);
    while (lssSent(0x11) == 0)
        bus->advance(1ms);
    bus->close();
    run.setBus(nullptr);
    EXPECT_FALSE(run.isRunning());
    EXPECT_TRUE(setup.isEnded());
    EXPECT_NE(setup.node(), Fate::notTried);
    EXPECT_NE(setup.store(), Fate::done);
    EXPECT_TRUE(setup.mayStayInConfiguration());
}

TEST_F(NodeSetupOnBus, WhatIsCancelledInTimeIsNotStoredAndNobodyStaysInConfiguration)
{
    operate();
    NodeSetup setup(toNode(9));
    run.start(setup);
    while (lssSent(0x11) == 0)
        bus->advance(1ms);
    run.cancel();
    for (int i = 0; i < 100 && run.isRunning(); ++i)
        bus->advance(20ms);
    EXPECT_EQ(setup.trouble(), Trouble::cancelled);
    EXPECT_EQ(setup.node(), Fate::done);
    EXPECT_EQ(setup.store(), Fate::notTried);
    EXPECT_EQ(lssSent(0x17), 0);
    EXPECT_FALSE(setup.mayStayInConfiguration());
    switchOffAndOn(encoderSix);
    EXPECT_EQ(numberOf(encoderSix), 6);
}

TEST_F(NodeSetupOnBus, OneThatSaysItHasStoredAndForgetsIsFoundAtItsOldNumber)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].quirks.lssForgets = true;
    connectAnew(encoders);
    operate();
    NodeSetup setup(toNode(9));
    carryOut(setup);
    EXPECT_EQ(setup.store(), Fate::done);
    EXPECT_EQ(check(9).result(), NodeCheck::Result::atOldNumber);
}

TEST_F(NodeSetupOnBus, OneThatForgetsWhatItStoresByLssKeepsWhatItStoresBy1010h)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].quirks.lssForgets = true;
    connectAnew(encoders);
    operate();
    NodeSetupWish wish = toNode(9);
    wish.way = NodeSetupWish::Way::lssWithoutStore;
    NodeSetup setup(wish);
    EXPECT_EQ(setup.steps(), (std::vector{SetupStep::free, SetupStep::select, SetupStep::node,
                                          SetupStep::leave, SetupStep::store, SetupStep::reset}));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    EXPECT_EQ(lssSent(0x17), 0);
    EXPECT_EQ(check(9).result(), NodeCheck::Result::found);
    switchOffAndOn(encoderSix);
    EXPECT_EQ(numberOf(encoderSix), 9);
}

TEST_F(NodeSetupOnBus, AStoreThatIsRefusedOutsideOfTheConfigurationLeavesItOnce)
{
    operate();
    plant->withEncoder(encoderSix, [](canopen::SimulatedNode &node) { node.setEepromBroken(true); });
    NodeSetupWish wish = toNode(9);
    wish.way = NodeSetupWish::Way::lssWithoutStore;
    NodeSetup setup(wish);
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::refused);
    EXPECT_EQ(setup.store(), Fate::notDone);
    EXPECT_FALSE(setup.isReset());
    EXPECT_EQ(lssSent(0x04), 2); // before it is selected, and afterwards
    EXPECT_EQ(setup.stateOf(3), NodeSetup::StepState::done);
    EXPECT_EQ(setup.stateOf(4), NodeSetup::StepState::failed);
    EXPECT_EQ(setup.stateOf(5), NodeSetup::StepState::leftOut);
}

TEST_F(NodeSetupOnBus, OneThatIsGoneAfterwardsIsSilent)
{
    operate();
    NodeSetup setup(toNode(9));
    carryOut(setup);
    plant->withEncoder(encoderSix, [](canopen::SimulatedNode &node) { node.setOn(false); });
    EXPECT_EQ(check(9).result(), NodeCheck::Result::silent);
}

TEST_F(NodeSetupOnBus, ADeviceWithoutANumberIsFoundAndTakesOneAtOnce)
{
    operate();
    LssSearch search(LssSelection::By::fastScan);
    carryOut(search);
    ASSERT_TRUE(search.selection().isSelected());
    EXPECT_EQ(search.selection().identity(), identityOfUnnumbered);
    EXPECT_EQ(search.selection().node(), std::nullopt);
    EXPECT_FALSE(search.mayStayInConfiguration());
    NodeSetup setup({.identity = identityOfUnnumbered, .node = 9});
    EXPECT_EQ(setup.steps(), (std::vector{SetupStep::free, SetupStep::select, SetupStep::node,
                                          SetupStep::store, SetupStep::leave}));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    NodeCheck found({.node = 9, .identity = identityOfUnnumbered});
    carryOut(found);
    EXPECT_EQ(found.result(), NodeCheck::Result::found);
    LssSearch again(LssSelection::By::fastScan);
    carryOut(again);
    EXPECT_EQ(again.selection().trouble(), LssSelection::Trouble::nobody);
}

TEST_F(NodeSetupOnBus, ASearchThatIsCancelledLeavesNobodyInConfiguration)
{
    operate();
    LssSearch search(LssSelection::By::fastScan);
    run.start(search);
    bus->advance(500ms);
    run.cancel();
    for (int i = 0; i < 100 && run.isRunning(); ++i)
        bus->advance(20ms);
    EXPECT_FALSE(run.isRunning());
    EXPECT_TRUE(search.isCancelled());
    EXPECT_FALSE(search.selection().isSelected());
}

// It is not at this rate any more then: what is stored is seen after its supply was off.
TEST_F(NodeSetupOnBus, ARateIsStoredAndNothingIsReset)
{
    operate();
    NodeSetupWish wish = toNode(6);
    wish.rate = *canopen::lssRate(250'000);
    NodeSetup setup(wish);
    EXPECT_EQ(setup.steps(),
              (std::vector{SetupStep::select, SetupStep::rate, SetupStep::store, SetupStep::leave}));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    EXPECT_EQ(setup.rate(), Fate::done);
    EXPECT_EQ(sentTo(0), 0);
    switchOffAndOn(encoderSix);
    EXPECT_EQ(plant->withEncoder(encoderSix, [](canopen::SimulatedNode &node) { return node.rate(); }),
              250'000);
}

TEST_F(NodeSetupOnBus, ANumberIsGivenByTheObjectThatTheDescriptionNames)
{
    operate();
    NodeSetupWish wish = toNode(9);
    wish.way = NodeSetupWish::Way::object;
    wish.nodeObject = {0x2000, 0};
    NodeSetup setup(wish);
    EXPECT_EQ(setup.steps(), (std::vector{SetupStep::free, SetupStep::identity, SetupStep::node,
                                          SetupStep::store, SetupStep::reset}));
    carryOut(setup);
    EXPECT_FALSE(setup.trouble());
    EXPECT_EQ(check(9).result(), NodeCheck::Result::found);
    EXPECT_EQ(sentTo(0x7E5), 0);
}

TEST_F(NodeSetupOnBus, AnObjectThatTheSwitchesDecideAboutIsRefused)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].quirks.hasSwitches = true;
    connectAnew(encoders);
    operate();
    NodeSetupWish wish = toNode(9);
    wish.way = NodeSetupWish::Way::object;
    wish.nodeObject = {0x2000, 0};
    NodeSetup setup(wish);
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::refused);
    EXPECT_EQ(setup.abortCode(), 0x0800'0021U);
    EXPECT_TRUE(setup.isUntouched());
}

TEST_F(NodeSetupOnBus, InWatchNothingIsSentAndTheReasonIsTold)
{
    open(EncoderBus::Start::watching);
    NodeSetup setup(toNode(9));
    carryOut(setup);
    EXPECT_EQ(setup.trouble(), Trouble::notSent);
    ASSERT_TRUE(run.whyRefused());
    EXPECT_EQ(run.whyRefused()->id, RefusalId::watchOnly);
    EXPECT_TRUE(link->sent.empty());
}

} // namespace
} // namespace codewheel
