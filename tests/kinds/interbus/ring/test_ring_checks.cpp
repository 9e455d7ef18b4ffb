// SPDX-License-Identifier: GPL-3.0-or-later
// Why there is no data of a ring: what each cause makes differ first, and what is said about it.
#include "bus/bus_outline.h"
#include "bus/data_check.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class RingChecks : public testing::Test
{
protected:
    // What is known of its encoders decides whether their positions are.
    RingChecks()
    {
        EXPECT_TRUE(bus.open(RingSession::Start::operating));
        for (const TrainingParticipant &participant : trainingPlan(catalog))
            for (const auto *known : {&participant.known, &participant.knownInWindow})
                for (const ParameterValue &value : *known)
                    bus.encoder(participant.number)->tell(value.parameter, value.value);
    }

    void befall(TrainingFault fault, Place place)
    {
        training.controls->setFault(fault, place.node, 1);
        frames();
    }
    void write(Place place, Word word)
    {
        bus.channel(place)->stage(word);
        EXPECT_TRUE(bus.channel(place)->write());
        frames();
    }
    void frames()
    {
        for (int i = 0; i < 25; ++i)
            bus.advance(33);
    }
    DataChecks of(Place place) const { return bus.dataChecks(place.node, planned); }
    void expectFirst(Place place, DataCheck::Id id, const char *remedy, DataCheck::Action action) const
    {
        const DataChecks checks = of(place);
        const DataCheck *first = firstDifference(checks);
        ASSERT_NE(first, nullptr);
        EXPECT_EQ(first->id, id) << first->what.toStdString();
        EXPECT_TRUE(first->remedy.startsWith(QLatin1String(remedy))) << first->remedy.toStdString();
        EXPECT_EQ(first->action, action);
    }

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    std::vector<Participant> planned{};
};

TEST_F(RingChecks, WhereDataComesAllIsAsExpectedUpToThePosition)
{
    frames();
    const DataChecks checks = of("2.0"_ring);
    EXPECT_EQ(firstDifference(checks), nullptr);
    EXPECT_TRUE(std::ranges::all_of(checks, [](const DataCheck &check) {
        return check.outcome == DataCheck::Outcome::asExpected && check.remedy.isEmpty();
    }));
    ASSERT_NE(findCheck(checks, DataCheck::Id::position), nullptr);
    EXPECT_FALSE(findCheck(checks, DataCheck::Id::position)->came.isEmpty());
}

// A ring that stands still behind a gateway shows the same for ever.
TEST_F(RingChecks, AWordThatDoesNotChangeSaysSinceWhen)
{
    const auto came = [this](Place place) {
        const DataChecks checks = of(place);
        const DataCheck *check = findCheck(checks, DataCheck::Id::upToDate);
        return check != nullptr ? check->came : QString();
    };
    frames();
    EXPECT_EQ(came("1.0"_ring), QStringLiteral("0 s ago"));
    bus.advance(11s);
    EXPECT_TRUE(came("1.0"_ring).startsWith(QStringLiteral("0 s ago, the same since ")))
        << came("1.0"_ring).toStdString();
    EXPECT_EQ(came("2.0"_ring), QStringLiteral("0 s ago")) << "its shaft turns";
    const auto stood = bus.encoder("1.0"_ring)->unchangedSince();
    bus.encoder("1.0"_ring)->tell(Parameter::startUpMode, 1);
    frames();
    EXPECT_EQ(bus.encoder("1.0"_ring)->unchangedSince(), stood) << "the meaning was told, the word stands";
    EXPECT_EQ(bus.encoder("2.0"_ring)->unchangedSince(), bus.encoder("2.0"_ring)->latest().at);
    training.controls->turnBy("1.0"_ring.node, 100);
    frames();
    EXPECT_EQ(came("1.0"_ring), QStringLiteral("0 s ago"));
    const auto before = bus.encoder("1.0"_ring)->unchangedSince();
    bus.setRunning(false);
    frames();
    EXPECT_FALSE(bus.encoder("1.0"_ring)->unchangedSince()) << "what came meanwhile was not seen";
    bus.setRunning(true);
    frames();
    EXPECT_GT(bus.encoder("1.0"_ring)->unchangedSince(), before);
}

TEST_F(RingChecks, ThatNothingCanBeWrittenInWatchIsOnlyARemark)
{
    bus.setOperate(false);
    frames();
    const DataChecks checks = of("2.0"_ring);
    EXPECT_EQ(firstDifference(checks), nullptr);
    const DataCheck *writing = findCheck(checks, DataCheck::Id::writing);
    ASSERT_NE(writing, nullptr);
    EXPECT_EQ(writing->outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(writing->action, DataCheck::Action::operate);
}

TEST_F(RingChecks, ABusThatIsNotConnectedSaysSoFirst)
{
    bus.close();
    for (const Place place : {"2.0"_ring, Place{firstBus, {}}}) {
        expectFirst(place, DataCheck::Id::link, "The bus is not connected.", DataCheck::Action::connectBus);
        EXPECT_EQ(of(place).size(), 1U);
    }
}

TEST_F(RingChecks, WhoStoppedTheRingIsSaid)
{
    frames();
    bus.setRunning(false);
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "The ring was stopped from here.",
                DataCheck::Action::start);
    bus.setRunning(true);
    frames();
    EXPECT_EQ(firstDifference(of("2.0"_ring)), nullptr);
    bus.alarmStop();
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "ALARM STOP has stopped the ring.",
                DataCheck::Action::start);
}

TEST_F(RingChecks, AWireBreakIsToldWithItsPlaceAndWhatIsBehindItIsNotKnown)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    expectFirst("2.0"_ring, DataCheck::Id::running, "The cable between 3.0 and 4.0 is interrupted",
                DataCheck::Action::start);
    const DataChecks checks = of("2.0"_ring);
    EXPECT_TRUE(firstDifference(checks)->came.startsWith(QStringLiteral("BUS FAIL at 4.0")))
        << firstDifference(checks)->came.toStdString();
    EXPECT_EQ(findCheck(checks, DataCheck::Id::position)->outcome, DataCheck::Outcome::notKnown);
    EXPECT_TRUE(findCheck(checks, DataCheck::Id::position)->came.isEmpty());
}

TEST_F(RingChecks, AFaultThatIsMendedIsWhatStoppedTheRing)
{
    frames();
    befall(TrainingFault::wireBreak, "4.0"_ring);
    training.controls->setFault(TrainingFault::wireBreak, "4.0"_ring.node, 0);
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "A fault has stopped the ring.",
                DataCheck::Action::start);
    bus.setRunning(true);
    frames();
    bus.setRunning(false);
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "The ring was stopped from here.",
                DataCheck::Action::start);
}

TEST_F(RingChecks, AFaultThatAStartHasMetIsToldUntilItChanges)
{
    befall(TrainingFault::wireBreak, "1.0"_ring);
    training.controls->setFault(TrainingFault::wireBreak, "1.0"_ring.node, 0);
    frames();
    befall(TrainingFault::wireBreak, "4.0"_ring);
    bus.setRunning(true);
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running,
                "The ring could not be started. The cable between 3.0 and 4.0 is interrupted",
                DataCheck::Action::start);
    EXPECT_EQ(firstDifference(of("2.0"_ring))->came,
              QStringLiteral("READY at 4.0 (0D10 at outgoing remote bus of 3.0 (see IBS SYS FW G4 UM))"));
    training.controls->setFault(TrainingFault::wireBreak, "4.0"_ring.node, 0);
    bus.setRunning(true);
    frames();
    EXPECT_EQ(firstDifference(of("2.0"_ring)), nullptr);
}

TEST_F(RingChecks, AnotherDeviceThatAStartHasMetIsTold)
{
    befall(TrainingFault::wireBreak, "1.0"_ring);
    training.controls->setFault(TrainingFault::wireBreak, "1.0"_ring.node, 0);
    frames();
    befall(TrainingFault::wrongDevice, "5.0"_ring);
    bus.setRunning(true);
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "The ring could not be started. 5.0: configured is",
                DataCheck::Action::start);
    bus.alarmStop();
    frames();
    expectFirst("2.0"_ring, DataCheck::Id::running, "ALARM STOP has stopped the ring.",
                DataCheck::Action::start);
}

TEST_F(RingChecks, ADeviceThatIsSwitchedOffIsNotReached)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    bus.switchSegment(4, false);
    frames();
    bus.setRunning(true);
    frames();
    EXPECT_EQ(firstDifference(of("2.0"_ring)), nullptr);
    expectFirst("4.0"_ring, DataCheck::Id::reached, "4.0 is not in the ring", DataCheck::Action::none);
}

TEST_F(RingChecks, AnEncoderWithoutSupplyIsARemarkSinceItMayBeAtZero)
{
    frames();
    befall(TrainingFault::powerOff, "2.0"_ring);
    const DataChecks checks = of("2.0"_ring);
    EXPECT_EQ(findCheck(checks, DataCheck::Id::state)->outcome, DataCheck::Outcome::remark);
    EXPECT_TRUE(findCheck(checks, DataCheck::Id::state)
                    ->remedy.startsWith(QStringLiteral("IN of 2.0 fell to 00000000")));
    EXPECT_EQ(findCheck(checks, DataCheck::Id::position)->outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(findCheck(checks, DataCheck::Id::position)->came, QStringLiteral("0, or no supply"));
}

// From near zero as well, and whatever is sent to it then.
TEST_F(RingChecks, AnEncoderWithoutSupplyStaysARemark)
{
    training.controls->setSpeed("2.0"_ring.node, 0);
    training.controls->turnTo("2.0"_ring.node, 376);
    frames();
    befall(TrainingFault::powerOff, "2.0"_ring);
    const auto isRemark = [&] {
        return findCheck(of("2.0"_ring), DataCheck::Id::state)->outcome == DataCheck::Outcome::remark;
    };
    EXPECT_TRUE(isRemark());
    bus.channel("2.0"_ring)->stage(0x0200'00FF);
    EXPECT_TRUE(bus.channel("2.0"_ring)->write());
    frames();
    EXPECT_TRUE(isRemark());
    write("2.0"_ring, 0);
    training.controls->setFault(TrainingFault::powerOff, "2.0"_ring.node, 0);
    for (int i = 0; i < 8; ++i) // that the word was not confirmed is told for 5 s
        frames();
    EXPECT_FALSE(isRemark());
}

TEST_F(RingChecks, AnErrorIsToldWithItsNumber)
{
    frames();
    befall(TrainingFault::codeDiscFault, "2.0"_ring);
    expectFirst("2.0"_ring, DataCheck::Id::state, "2.0: Error 15: ", DataCheck::Action::monitor);
    EXPECT_TRUE(firstDifference(of("2.0"_ring))->came.startsWith(QStringLiteral("error 15 (IN 9E000000)")));
    expectFirst({firstBus, {}}, DataCheck::Id::devices, "2.0: Error 15: ", DataCheck::Action::none);
}

TEST_F(RingChecks, ParameterizationIsTold)
{
    frames();
    write("2.0"_ring, 0x0200'00FF);
    expectFirst("2.0"_ring, DataCheck::Id::state, "The encoder is in parameterization",
                DataCheck::Action::monitor);
}

TEST_F(RingChecks, AReadOutValueIsNotTakenForAPosition)
{
    frames();
    write("1.0"_ring, 0x2021'0001);
    expectFirst("1.0"_ring, DataCheck::Id::state, "The encoder tests itself, or shows a value",
                DataCheck::Action::monitor);
}

TEST_F(RingChecks, AFaultOfThePeripheryIsARemarkOfItsDeviceOnly)
{
    frames();
    befall(TrainingFault::peripheralFault, "3.0"_ring);
    const DataChecks checks = of("3.0"_ring);
    EXPECT_EQ(firstDifference(checks), nullptr) << "the ring runs on: its data comes all the same";
    const DataCheck &master = *findCheck(checks, DataCheck::Id::master);
    EXPECT_EQ(master.outcome, DataCheck::Outcome::remark);
    EXPECT_TRUE(master.remedy.startsWith(QStringLiteral("3.0 reports a fault of its periphery")));
    EXPECT_EQ(findCheck(of("2.0"_ring), DataCheck::Id::master)->outcome, DataCheck::Outcome::asExpected);
}

TEST_F(RingChecks, AnotherDeviceThanPlannedIsTold)
{
    frames();
    planned = participantsOf(bus.structure());
    EXPECT_EQ(firstDifference(of("2.0"_ring)), nullptr);
    const auto at = std::ranges::find(planned, "2.0"_ring.node, &Participant::number);
    at->deviceCode = 0x0233;
    at->deviceKey.clear();
    expectFirst("2.0"_ring, DataCheck::Id::kind, "2.0: configured is ", DataCheck::Action::compare);
    EXPECT_TRUE(findCheck(of("2.0"_ring), DataCheck::Id::kind)->expected.endsWith(QStringLiteral("33h")));
}

TEST_F(RingChecks, ABusTerminalIsCalledSoWithItsCode)
{
    frames();
    EXPECT_EQ(findCheck(of("6.0"_ring), DataCheck::Id::kind)->came, QStringLiteral("bus terminal, 0Ch"));
}

TEST_F(RingChecks, ADeviceThatIsOnlyPlannedIsNotThere)
{
    frames();
    expectFirst("99.0"_ring, DataCheck::Id::reached, "99.0 is not in the ring", DataCheck::Action::compare);
}

// Nobody has chosen that mode, and the controller takes the cams for a position.
TEST_F(RingChecks, AnEncoderThatAJobHasLeftInCamModeShowsNoPosition)
{
    const Place fraba = "1.0"_ring;
    EncoderSession &encoder = *bus.encoder(fraba);
    const auto alarmStopInCamMode = [&](const Job &job) {
        ASSERT_TRUE(encoder.start(job));
        for (int i = 0; i < 300 && encoder.latest().mode != Mode::cam; ++i)
            bus.advance(1);
        ASSERT_EQ(encoder.latest().mode, Mode::cam);
        bus.alarmStop();
        frames();
        bus.setRunning(true);
        frames();
    };
    encoder.tell(Parameter::startUpMode, 1);
    QStringList told;
    QObject::connect(&bus, &EncoderBus::messaged, &bus,
                     [&](const Message &message) { told << messageText(message); });
    frames();
    alarmStopInCamMode(WriteCams{
        .programs = {CamProgram{}}, .onlyWhatDiffers = true, .afterwards = SwitchMode{Mode::position}});
    EXPECT_EQ(encoder.leftInMode(), (LeftMode{Mode::cam, 1}));
    EXPECT_TRUE(told.contains(QStringLiteral("The encoder was left in cam mode, program 1: the controller "
                                             "gets no position. Switch it back to position mode.")))
        << told.join(u'\n').toStdString();
    expectFirst(fraba, DataCheck::Id::position, "The encoder was left in cam mode, program 1",
                DataCheck::Action::none);
    const auto faults = bus.outline().faults();
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults.front().actions, std::vector{FaultAction::positionMode});

    bus.setOperate(true);
    ASSERT_TRUE(encoder.start(SwitchMode{Mode::position}));
    frames();
    EXPECT_FALSE(encoder.leftInMode());
    EXPECT_EQ(firstDifference(of(fraba)), nullptr);
    EXPECT_TRUE(bus.outline().faults().empty());
}

// ALARM STOP came while the word that switches it was on its way.
TEST_F(RingChecks, AModeThatIsNotKnownAfterAnAlarmStopIsNotClaimed)
{
    const Place fraba = "1.0"_ring;
    EncoderSession &encoder = *bus.encoder(fraba);
    encoder.tell(Parameter::startUpMode, 1);
    frames();
    ASSERT_TRUE(encoder.start(ReadCams{.programs = {1}, .afterwards = SwitchMode{Mode::position}}));
    for (int i = 0; i < 20 && bus.channel(fraba)->out() != 0x2080'0001; ++i)
        bus.advance(1);
    bus.alarmStop();
    frames();
    bus.setRunning(true);
    frames();
    EXPECT_EQ(encoder.leftInMode(), LeftMode());
    ASSERT_EQ(bus.outline().faults().size(), 1u);
    EXPECT_TRUE(
        bus.outline().faults().front().text.startsWith(QStringLiteral("It is not known in which mode 1.0")));
    expectFirst(fraba, DataCheck::Id::position, "IN may be a position", DataCheck::Action::positionMode);

    encoder.tell(Parameter::startUpMode, 1);
    frames();
    EXPECT_TRUE(bus.outline().faults().empty());
}

TEST_F(RingChecks, CamModeThatWasAskedForIsNoDifference)
{
    const Place fraba = "1.0"_ring;
    EncoderSession &encoder = *bus.encoder(fraba);
    encoder.tell(Parameter::startUpMode, 1);
    frames();
    ASSERT_TRUE(encoder.start(SwitchMode{Mode::cam, 1}));
    frames();
    ASSERT_EQ(encoder.latest().mode, Mode::cam);
    EXPECT_EQ(firstDifference(of(fraba)), nullptr);
    EXPECT_TRUE(bus.outline().faults().empty());
}

} // namespace
} // namespace codewheel
