// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_link.h"
#include "tests/support/places.h"
#include "tests/support/simulated_gateway.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/last_positions.h"

namespace codewheel {
namespace {

using test::fraba;
using Since = SeenPosition::Since;
using Scaled = SeenPosition::Scaled;

class LastPositionsOfTheRing : public test::TransferBus
{
protected:
    void pass(int milliseconds)
    {
        for (int i = 0; i < milliseconds / 33 + 1; ++i)
            bus.advance(33);
    }
    // The encoder goes for a moment, and comes back somewhere else, as another one does.
    void goAndReturn(std::int64_t turnedBy = 100)
    {
        training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
        pass(2000);
        training.controls->turnBy(fraba.node, turnedBy);
        training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
        pass(500);
    }
    void stop()
    {
        bus.setRunning(false);
        pass(3000);
    }
    void start()
    {
        bus.setRunning(true);
        pass(500);
    }
    void carryOutJob(const Job &job)
    {
        ASSERT_TRUE(encoder(fraba).start(job));
        pass(3000);
        ASSERT_FALSE(encoder(fraba).runningJob());
    }
    LastPositions positions{buses};
};

TEST_F(LastPositionsOfTheRing, AreThoseTheEncodersShow)
{
    pass(100);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->position, encoder(fraba).latest().position);
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
    EXPECT_FALSE(positions.at("9.0"_ring));
}

TEST_F(LastPositionsOfTheRing, ThePositionBeforeAnEncoderWentIsKeptWhenAnotherOneIsThere)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.at(fraba)->since, Since::gone);

    training.controls->turnBy(fraba.node, 100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(3000);
    EXPECT_NE(encoder(fraba).latest().position, before);
    EXPECT_EQ(positions.at(fraba)->position, before);
}

// Nobody saw it go, and the new one shows itself, goes, and comes back somewhere else.
TEST_F(LastPositionsOfTheRing, ThePositionBeforeAReplacementIsThatOfTheEncoderThatWasThere)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    const auto isOfBefore = [&] { return positions.at(fraba)->position == before; };
    positions.takeReplaced(fraba);
    goAndReturn(20'000);
    EXPECT_TRUE(isOfBefore());
    positions.takeReplaced(fraba);
    goAndReturn();
    EXPECT_TRUE(isOfBefore());
    EXPECT_EQ(positions.at(fraba)->since, Since::gone);
    EXPECT_EQ(positions.newest(fraba)->position, encoder(fraba).latest().position);
    carryOutJob(WriteParameters{{{Parameter::preset, 1}}, false, {}});
    goAndReturn();
    EXPECT_FALSE(isOfBefore()) << "it is in use";
}

TEST_F(LastPositionsOfTheRing, AnEncoderBehindAFaultOfTheRingIsGone)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    training.controls->setFault(TrainingFault::noSupply, fraba.node, 1);
    pass(17'000);
    ASSERT_FALSE(bus.isRunning());
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.at(fraba)->since, Since::gone);
    training.controls->turnBy(fraba.node, 100);
    training.controls->setFault(TrainingFault::noSupply, fraba.node, 0);
    bus.setRunning(true);
    pass(3000);
    ASSERT_TRUE(bus.isRunning());
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.at(fraba)->since, Since::gone);
}

TEST_F(LastPositionsOfTheRing, AnEncoderThatComesBackWhereItWasIsTheSame)
{
    pass(100);
    goAndReturn(0);
    training.controls->turnBy(fraba.node, 100);
    pass(500);
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
    EXPECT_EQ(positions.at(fraba)->position, encoder(fraba).latest().position);
    EXPECT_EQ(positions.at(fraba), positions.newest(fraba));
}

// The new encoder lost its supply once more: the previous one is still that of the first time.
TEST_F(LastPositionsOfTheRing, ASecondLossThatEndsWhereItBeganKeepsThePositionBeforeTheFirst)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    goAndReturn();
    const auto since = encoder(fraba).latest().position;
    ASSERT_NE(since, before);
    const auto both = [&](const char *when) {
        EXPECT_EQ(positions.at(fraba)->position, before) << when;
        EXPECT_EQ(positions.at(fraba)->since, Since::gone) << when;
        EXPECT_EQ(positions.newest(fraba)->position, since) << when;
    };
    both("after the first loss");
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    both("in the second one");
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(500);
    both("after it");
}

TEST_F(LastPositionsOfTheRing, AWireBreakAfterTheFirstLossKeepsThePositionBeforeIt)
{
    using test::onLoop;
    pass(100);
    const auto before = encoder(onLoop).latest().position;
    training.controls->setFault(TrainingFault::powerOff, onLoop.node, 1);
    pass(3000);
    training.controls->turnBy(onLoop.node, 100);
    training.controls->setFault(TrainingFault::powerOff, onLoop.node, 0);
    pass(3000);
    const auto since = encoder(onLoop).latest().position;
    ASSERT_NE(since, before);
    training.controls->setFault(TrainingFault::wireBreak, onLoop.node, 1);
    pass(17'000);
    training.controls->setFault(TrainingFault::wireBreak, onLoop.node, 0);
    ASSERT_FALSE(bus.isRunning());
    EXPECT_EQ(positions.at(onLoop)->position, before);
    EXPECT_EQ(positions.newest(onLoop)->position, since);
    bus.setRunning(true);
    pass(3000);
    ASSERT_EQ(encoder(onLoop).latest().position, since);
    EXPECT_EQ(positions.at(onLoop)->position, before);
    EXPECT_EQ(positions.at(onLoop)->since, Since::gone);
}

TEST_F(LastPositionsOfTheRing, ASecondLossThatEndsElsewhereIsTheOneThatCounts)
{
    pass(100);
    goAndReturn();
    const auto since = encoder(fraba).latest().position;
    goAndReturn();
    EXPECT_EQ(positions.at(fraba)->position, since);
    goAndReturn(0);
    EXPECT_EQ(positions.at(fraba)->position, since);
}

// What was written to it since makes it the one that works there.
TEST_F(LastPositionsOfTheRing, ASecondLossAfterThePositionWasSetIsThatOfTheEncoderInUse)
{
    pass(100);
    goAndReturn();
    carryOutJob(SetPreset{.value = 100});
    const auto inUse = encoder(fraba).latest().position;
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    EXPECT_EQ(positions.at(fraba)->position, inUse);
    EXPECT_EQ(positions.at(fraba), positions.newest(fraba));
}

TEST_F(LastPositionsOfTheRing, APositionThatIsZeroForAMomentIsNoEncoderThatWent)
{
    pass(100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(300);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(100);
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
}

// Nobody looked meanwhile, and the encoder is there.
TEST_F(LastPositionsOfTheRing, APauseOfTheComputerIsNoEncoderThatWent)
{
    pass(100);
    bus.advance(3000);
    pass(100);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
    EXPECT_EQ(positions.at(fraba)->position, encoder(fraba).latest().position);
}

TEST_F(LastPositionsOfTheRing, APauseInWhichAnEncoderCouldBeReplacedIsTold)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    training.controls->turnBy(fraba.node, 100);
    bus.advance(60'000);
    pass(100);
    ASSERT_TRUE(positions.at(fraba));
    EXPECT_EQ(positions.at(fraba)->since, Since::unwatched);
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.newest(fraba)->position, encoder(fraba).latest().position);
}

TEST_F(LastPositionsOfTheRing, AStoppedBusIsNoEncoderThatWent)
{
    pass(100);
    stop();
    EXPECT_EQ(positions.at(fraba)->since, Since::unwatched);
    start();
    EXPECT_EQ(positions.at(fraba)->since, Since::unwatched);
}

// However short it was: people stop it in order to replace an encoder.
TEST_F(LastPositionsOfTheRing, ThePositionBeforeAStopIsKept)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    stop();
    training.controls->turnBy(fraba.node, 100);
    start();
    ASSERT_NE(encoder(fraba).latest().position, before);
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.at(fraba)->since, Since::unwatched);
    EXPECT_EQ(positions.newest(fraba)->position, encoder(fraba).latest().position);
}

TEST_F(LastPositionsOfTheRing, ASecondStopThatEndsWhereItBeganKeepsThePositionBeforeTheFirst)
{
    pass(100);
    const auto before = encoder(fraba).latest().position;
    stop();
    training.controls->turnBy(fraba.node, 100);
    start();
    const auto since = encoder(fraba).latest().position;
    stop();
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.newest(fraba)->position, since);
    start();
    EXPECT_EQ(positions.at(fraba)->position, before);
    EXPECT_EQ(positions.newest(fraba)->position, since);
}

TEST_F(LastPositionsOfTheRing, AnEncoderThatIsParameterizedOrInErrorIsThere)
{
    pass(100);
    training.controls->setFault(TrainingFault::parametersLost, fraba.node, 1);
    pass(3000);
    ASSERT_EQ(encoder(fraba).latest().state, EncoderState::error);
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
}

TEST_F(LastPositionsOfTheRing, APositionFromBeforeAnotherScaleSaysSo)
{
    encoder(fraba).tell(Parameter::steps, 300);
    pass(100);
    goAndReturn();
    ASSERT_EQ(positions.at(fraba)->since, Since::gone);
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::asThen);
    carryOutJob(WriteParameters{.values = {{Parameter::steps, 2048}}, .previous = {}});
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::otherwise);
    goAndReturn();
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::asThen) << "this one was seen with the new scale";
}

// As after a replacement that was cancelled: the old encoder may have had the same values.
TEST_F(LastPositionsOfTheRing, AScaleThatNobodyKnewIsNotSaidToBeAnother)
{
    pass(100);
    goAndReturn();
    carryOutJob(WriteParameters{.values = {{Parameter::steps, 2048}}, .previous = {}});
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::perhapsOtherwise);
}

TEST_F(LastPositionsOfTheRing, AKeptPositionIsComparedWithWhatCameAfterIt)
{
    encoder(fraba).tell(Parameter::steps, 300);
    pass(100);
    const auto kept = positionToKeep(encoder(fraba));
    ASSERT_TRUE(kept);
    EXPECT_EQ(valueOf(kept->scale, Parameter::steps), 300);
    EXPECT_EQ(positions.kept(fraba, *kept).scaled, Scaled::asThen);
    EXPECT_EQ(positions.kept(fraba, *kept).position, kept->position);
    goAndReturn();
    carryOutJob(WriteParameters{.values = {{Parameter::steps, 2048}}, .previous = {}});
    EXPECT_EQ(positions.kept(fraba, *kept).scaled, Scaled::otherwise);
    encoder(fraba).tell(Parameter::steps, {});
    EXPECT_EQ(positions.kept(fraba, *kept).scaled, Scaled::otherwise) << "it was seen with that scale";
}

TEST_F(LastPositionsOfTheRing, APositionFromBeforeAnotherZeroSaysSo)
{
    pass(100);
    goAndReturn();
    ASSERT_EQ(positions.at(fraba)->scaled, Scaled::asThen);
    carryOutJob(ReadParameters{{Parameter::steps, Parameter::zeroOffset}});
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::asThen) << "reading changes nothing";
    carryOutJob(SetPreset{.value = 100});
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::perhapsOtherwise);
}

// As a replacement that is tried before the supply is on again: the position before is right still.
TEST_F(LastPositionsOfTheRing, NothingIsWrittenToAnEncoderThatDoesNotAnswer)
{
    pass(100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    carryOutJob(SwitchMode{});
    carryOutJob(WriteParameters{.values = {{Parameter::steps, 2048}}, .previous = {}});
    carryOutJob(SetPreset{.value = 376});
    EXPECT_EQ(positions.at(fraba)->scaled, Scaled::asThen);
    EXPECT_EQ(positions.at(fraba)->since, Since::gone);
}

// Even for a moment. Whoever answers says what came of it.
TEST_F(LastPositionsOfTheRing, AfterALostLinkItIsNotSaidThatTheEncoderWasThereAllTheTime)
{
    pass(100);
    const auto meetAgain = [this] {
        encoder(fraba).setKnownBefore(
            KnownBefore{.values = {{.parameter = Parameter::steps, .value = 8'192}}});
        Q_EMIT bus.meetsAgain();
        pass(100);
    };
    ASSERT_EQ(positions.at(fraba)->since, Since::there);
    meetAgain();
    EXPECT_EQ(positions.at(fraba)->since, Since::unwatched);
    encoder(fraba).takeKnownBefore();
    pass(100);
    EXPECT_EQ(positions.at(fraba)->since, Since::there);
    meetAgain();
    encoder(fraba).setKnownBefore({});
    EXPECT_EQ(positions.at(fraba)->since, Since::gone) << "another one";
}

// Behind a gateway there are real ones.
TEST_F(LastPositionsOfTheRing, OfSimulatedEncodersAreNotThoseOfARealRing)
{
    pass(100);
    ASSERT_TRUE(positions.at(test::singleTurn));
    TrainingBus other = makeTrainingBus(catalog);
    auto ring = std::dynamic_pointer_cast<SimulatedRing>(other.controls);
    other.controls->turnBy(test::singleTurn.node, 1'000);
    bus.useLink(std::make_unique<GatewayLink>(
                    std::make_unique<test::SimulatedGatewayPort>(
                        std::make_shared<test::SimulatedGateway>(ring, test::SimulatedGateway::Ways())),
                    GatewaySettings(), test::gatewayDevices(*ring, catalog)),
                bus.dateTime(bus.now()));
    ASSERT_TRUE(bus.open(EncoderBus::Start::watching));
    EXPECT_FALSE(positions.at(test::singleTurn));
    EXPECT_FALSE(positions.newest(test::singleTurn));
    pass(3000);
    ASSERT_TRUE(positions.at(test::singleTurn));
    EXPECT_EQ(positions.at(test::singleTurn)->position, encoder(test::singleTurn).latest().position);
    EXPECT_EQ(positions.at(test::singleTurn), positions.newest(test::singleTurn));
}

TEST_F(LastPositionsOfTheRing, AreKeptWithTheProjectWhenItIsSaved)
{
    Project project;
    for (const RingDevice &participant : bus.structure()) {
        project.devices.emplace_back().participant = participant;
        project.devices.back().lastPosition = {1, QDateTime(QDate(2026, 2, 1), QTime(8, 0), Qt::UTC)};
    }
    encoder(fraba).tell(Parameter::steps, 8192);
    pass(100);
    const auto before = encoder(fraba).latest().position;
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, before);
    EXPECT_EQ(valueOf(withLastPositions(project, positions, buses).devices[0].lastPosition->scale,
                      Parameter::steps),
              8192);

    training.controls->setFault(TrainingFault::powerOff, fraba.node,
                                1); // it dies, and is replaced later
    pass(3000);
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, before);
    training.controls->turnBy(fraba.node, 100);
    training.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(3000);
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position,
              encoder(fraba).latest().position);

    project.devices[0].participant.deviceCode = 0x0236; // another kind is now planned there
    EXPECT_EQ(withLastPositions(project, positions, buses).devices[0].lastPosition->position, 1);
}

} // namespace
} // namespace codewheel
