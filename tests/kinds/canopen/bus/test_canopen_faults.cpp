// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "bus/data_check.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::NmtState;

class CanopenBusFaults : public test::CanopenPlant
{
protected:
    static bool isPreset(const CanFrame &frame)
    {
        return frame.id == 0x606 && frame.bytes[0] == 0x23 && frame.bytes[1] == 0x03;
    }
    std::optional<DataCheck> difference(NodeId node = {})
    {
        const DataChecks checks = bus->dataChecks(node, {});
        const DataCheck *first = firstDifference(checks);
        return first != nullptr ? std::optional(*first) : std::nullopt;
    }
};

TEST_F(CanopenBusFaults, APresetWhoseAnswerNobodySeesIsInDoubt)
{
    operate();
    link->goneAfter = isPreset;
    const auto outcome = carryOut(six, SetPreset{.value = 1'000});
    ASSERT_TRUE(outcome);
    ASSERT_FALSE(outcome->result);
    EXPECT_EQ(outcome->result.error().id, CanRefusalId::interfaceLost);
    EXPECT_TRUE(outcome->inDoubt.position);
    EXPECT_EQ(bus->state(), BusState::lost);
    EXPECT_EQ(std::ranges::count_if(link->sent, isPreset), 1);
    EXPECT_TRUE(isRefusalTold(CanRefusalId::interfaceLost));
    EXPECT_TRUE(bus->encoder(six)->freshness().isOld());
    ASSERT_FALSE(bus->outline().faults().empty());
    EXPECT_EQ(bus->outline().faults().front().extent, Fault::Extent::standstill);
}

TEST_F(CanopenBusFaults, ALinkThatIsBackIsInWatchAndSendsNothing)
{
    operate();
    link->isGone = true;
    bus->advance(5s);
    EXPECT_EQ(bus->state(), BusState::lost);
    EXPECT_EQ(std::ranges::count_if(messages, [](const Message &each) { return each.refusal.has_value(); }),
              1)
        << "said once";
    const auto sent = link->sent.size();
    link->isGone = false;
    bus->advance(3s);
    EXPECT_EQ(bus->state(), BusState::open);
    EXPECT_EQ(countOf(CanopenBusMessageId::back), 1);
    EXPECT_FALSE(bus->isOperating());
    EXPECT_EQ(link->uses.back(), CanUse::watch);
    EXPECT_EQ(link->sent.size(), sent);
    bus->setOperate(true);
    bus->advance(2s);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive());
    const auto outcome = carryOut(five, ReadParameters{{Parameter::serialNumber}});
    ASSERT_TRUE(outcome && outcome->result);
}

// A pseudo terminal whose number goes from one program to the next, for example.
TEST_F(CanopenBusFaults, WhatIsInTheWayOfOpeningAgainIsSaidOnceAlsoWhereItAlternates)
{
    open(EncoderBus::Start::watching);
    link->isGone = true;
    bus->advance(2s);
    messages.clear();
    const Refusal taken{RefusalKind::link, RefusalId::portInUse, {QStringLiteral("/dev/pts/0")}};
    const Refusal missing{RefusalKind::link, RefusalId::portNotFound, {QStringLiteral("/dev/pts/0")}};
    for (int i = 0; i < 5; ++i)
        for (const Refusal &reason : {taken, missing}) {
            link->inTheWay = reason;
            bus->advance(1s);
            EXPECT_EQ(bus->latest().whyLost, reason);
        }
    EXPECT_EQ(std::ranges::count(messages, taken, &Message::refusal), 1);
    EXPECT_EQ(std::ranges::count(messages, missing, &Message::refusal), 1);
    EXPECT_EQ(messages.size(), 2U);
}

TEST_F(CanopenBusFaults, BusOffIsALostLink)
{
    operate();
    plant->bus()->forceBusOff(*link->adapter());
    bus->advance(200ms);
    EXPECT_EQ(bus->state(), BusState::lost);
    EXPECT_TRUE(isRefusalTold(CanRefusalId::busOff));
    bus->advance(2s);
    EXPECT_EQ(bus->state(), BusState::open);
    EXPECT_FALSE(bus->isOperating());
}

TEST_F(CanopenBusFaults, AFullQueueIsWaitedFor)
{
    open(EncoderBus::Start::operating);
    link->isFull = true;
    bus->advance(3s);
    EXPECT_TRUE(link->sent.empty());
    EXPECT_NE(bus->encoder(five)->latest().state, EncoderState::silent) << "it was not asked";
    link->isFull = false;
    bus->advance(2s);
    EXPECT_TRUE(bus->encoder(five)->latest().position);
}

TEST_F(CanopenBusFaults, WatchingThatIsNotSureIsAskedFor)
{
    link->isUnsure = true;
    const auto opened = bus->open({}, EncoderBus::Start::watching, EncoderBus::Drive::byHand);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().id, CanRefusalId::watchNotSure);
    EXPECT_EQ(bus->state(), BusState::closed);
    bus->takeUnsureWatch();
    EXPECT_TRUE(bus->open({}, EncoderBus::Start::watching, EncoderBus::Drive::byHand));
}

TEST_F(CanopenBusFaults, WatchingThatIsNotSureAfterOperateIsAskedForToo)
{
    operate();
    link->isUnsure = true;
    std::optional<Refusal> unsure;
    QObject::connect(bus.get(), &CanopenSession::watchNotSure, bus.get(),
                     [&](const Refusal &why) { unsure = why; });
    bus->setOperate(false);
    bus->advance(3s);
    EXPECT_TRUE(unsure);
    EXPECT_EQ(bus->state(), BusState::lost) << "nothing is acknowledged unasked";
    bus->takeUnsureWatch();
    bus->advance(100ms);
    EXPECT_EQ(bus->state(), BusState::open);
}

TEST_F(CanopenBusFaults, AnAlarmStopStopsTheNodesThatWereStartedFromHere)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(500ms);
    say(test::canFrame(0, {1, 7}));
    bus->advance(100ms);
    ASSERT_EQ(stateOf(1), NmtState::operational);
    ASSERT_EQ(stateOf(2), NmtState::operational);
    std::optional<Outcome> outcome;
    QObject::connect(bus->encoder(six), &EncoderSession::finished, bus.get(),
                     [&](const Outcome &ended) { outcome = ended; });
    bus->sendBesideOthers();
    bus->advance(10ms);
    ASSERT_TRUE(bus->encoder(six)->start(SetPreset{.value = 1}, Pace::byHand));
    bus->advance(100ms);
    bus->alarmStop();
    bus->advance(50ms);
    EXPECT_EQ(stateOf(1), NmtState::stopped);
    EXPECT_EQ(stateOf(2), NmtState::operational) << "another one has started it";
    EXPECT_EQ(stateOf(0), NmtState::preOperational);
    ASSERT_TRUE(outcome && !outcome->result);
    EXPECT_EQ(outcome->result.error().id, RefusalId::alarmStop);
    EXPECT_EQ(countOf(CanopenBusMessageId::nodesStopped), 1);
    EXPECT_FALSE(bus->waitsForZeros());
    bus->alarmStop();
    bus->advance(50ms);
    EXPECT_EQ(countOf(CanopenBusMessageId::nodesStopped), 1) << "none is running";
}

TEST_F(CanopenBusFaults, AnAlarmStopInWatchIsSentAndItStaysInWatch)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(100ms);
    bus->setOperate(false);
    bus->advance(100ms);
    bus->alarmStop();
    bus->advance(50ms);
    EXPECT_EQ(stateOf(1), NmtState::stopped);
    EXPECT_FALSE(bus->isOperating());
    EXPECT_EQ(link->uses.back(), CanUse::watch);
}

TEST_F(CanopenBusFaults, AnAlarmStopBehindAFullQueueWaits)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(100ms);
    link->isFull = true;
    bus->alarmStop();
    bus->advance(50ms);
    EXPECT_TRUE(bus->waitsForZeros());
    link->isFull = false;
    bus->advance(50ms);
    EXPECT_FALSE(bus->waitsForZeros());
    EXPECT_EQ(stateOf(1), NmtState::stopped);
}

TEST_F(CanopenBusFaults, AnAlarmStopBehindAFullQueueIsSentAfterTheSwitchToWatch)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(100ms);
    link->isFull = true;
    bus->alarmStop();
    bus->advance(50ms);
    bus->setOperate(false);
    bus->advance(50ms);
    EXPECT_TRUE(bus->waitsForZeros());
    link->isFull = false;
    bus->advance(200ms);
    EXPECT_FALSE(bus->waitsForZeros());
    EXPECT_EQ(stateOf(1), NmtState::stopped);
}

TEST_F(CanopenBusFaults, AnAlarmStopBeforeClosingIsSent)
{
    operate();
    bus->send(test::canFrame(0, {1, 6}));
    bus->advance(100ms);
    bus->alarmStop();
    bus->close();
    EXPECT_EQ(stateOf(1), NmtState::stopped);
}

TEST_F(CanopenBusFaults, TwoNodesWithOneNumberAreNoticed)
{
    talker->answersAs = 6;
    operate(5s);
    EXPECT_EQ(countOf(CanopenBusMessageId::nodeDoubled), 1);
    ASSERT_NE(bus->latest().heard(6), nullptr);
    EXPECT_TRUE(bus->latest().heard(6)->isDoubled);
    const auto faults = bus->outline().faults();
    EXPECT_EQ(std::ranges::count(faults, six.node, &Fault::node), 1);
    const auto check = difference(six.node);
    ASSERT_TRUE(check);
    EXPECT_EQ(check->id, DataCheck::Id::reached);
    plant->bus()->locked([&] {
        talker->answersAs = 0;
        talker->frames.clear();
    });
    bus->advance(3s);
    EXPECT_FALSE(bus->latest().heard(6)->isDoubled);
}

// Neither has a heartbeat, and what both send at once is destroyed.
TEST_F(CanopenBusFaults, TwoNodesThatDestroyTheirFramesMayHaveOneNumber)
{
    auto encoders = canopen::trainingEncoders();
    for (canopen::CanopenEncoderPlan &each : encoders) {
        each.cyclicTimer = 10;
        each.heartbeat = 0;
        each.quirks.startsItself = true;
    }
    encoders[2].node = 6;
    connectTo(encoders);
    operate(10s);
    ASSERT_FALSE(bus->latest().heard(6)->isDoubled);
    const auto check = difference(six.node);
    ASSERT_TRUE(check);
    EXPECT_EQ(check->id, DataCheck::Id::reached);
    EXPECT_TRUE(check->remedy.contains(QStringLiteral("two devices may have its number")))
        << check->remedy.toStdString();
}

// Each of their frames is held back, so that answers to requests that have timed out go on coming.
TEST_F(CanopenBusFaults, NodesThatAnswerLateAreNotTwo)
{
    for (const Instant delay : {300ms, 600ms, 1'000ms, 1'500ms}) {
        connectTo(canopen::trainingEncoders());
        plant->bus()->setFaults({.late = 1'000, .delay = delay});
        messages.clear();
        operate(120s);
        EXPECT_EQ(countOf(CanopenBusMessageId::nodeDoubled), 0) << delay.count();
    }
}

TEST_F(CanopenBusFaults, AJobOfADoubledNumberIsRefusedAndOneUnderWayEnds)
{
    operate();
    std::optional<Outcome> ended;
    QObject::connect(bus->encoder(six), &EncoderSession::finished, bus.get(),
                     [&](const Outcome &outcome) { ended = outcome; });
    ASSERT_TRUE(bus->encoder(six)->start(WriteParameters{{{Parameter::steps, 4000}}, false, {}}));
    plant->bus()->locked([&] { talker->answersAs = 6; });
    bus->advance(2s);
    ASSERT_TRUE(ended && !ended->result);
    EXPECT_EQ(ended->result.error().id, CanopenRefusalId::nodeDoubled);
    EXPECT_TRUE(ended->written.empty());
    link->sent.clear();
    const auto outcome = carryOut(six, SetPreset{.value = 5});
    const auto why = outcome ? std::optional(outcome->result.error()) : refused;
    ASSERT_TRUE(why);
    EXPECT_EQ(why->id, CanopenRefusalId::nodeDoubled);
    EXPECT_EQ(std::ranges::count_if(link->sent, isPreset), 0);
}

TEST_F(CanopenBusFaults, AnotherMasterIsNamedAndNothingIsSentUnasked)
{
    open(EncoderBus::Start::watching);
    say(test::canFrame(0x080, {}));
    bus->advance(100ms);
    EXPECT_EQ(countOf(CanopenBusMessageId::otherMasterHeard), 1);
    bus->setOperate(true);
    bus->advance(2s);
    EXPECT_TRUE(bus->isOperating());
    EXPECT_TRUE(link->sent.empty());
    EXPECT_FALSE(carryOut(five, ReadParameters{{Parameter::serialNumber}}));
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->id, CanopenBusRefusalId::otherMaster);
    bus->sendBesideOthers();
    bus->advance(2s);
    EXPECT_FALSE(link->sent.empty());
    const auto outcome = carryOut(five, ReadParameters{{Parameter::serialNumber}});
    EXPECT_TRUE(outcome && outcome->result);
}

// Whoever speaks only that is not spoken to, until something else is heard.
TEST_F(CanopenBusFaults, WhereOnlyJ1939IsHeardNothingIsSentUnasked)
{
    connectTo({});
    plant->bus()->add(std::make_shared<test::Talker>()); // acknowledges
    open(EncoderBus::Start::watching);
    CanFrame j1939 = test::canFrame(0x0CFFE0E0, {1, 2, 3, 4, 5, 6, 7, 8});
    j1939.isExtended = true;
    say(j1939);
    bus->advance(100ms);
    bus->setOperate(true);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 5}.frame());
    bus->transfer({.node = 5, .object = {0x1018, 1}});
    bus->scan();
    bus->advance(2s);
    EXPECT_TRUE(link->sent.empty());
    EXPECT_FALSE(carryOut(five, ReadParameters{{Parameter::serialNumber}}));
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->id, CanopenBusRefusalId::onlyJ1939);
    const DataChecks checks = bus->dataChecks(five.node, {});
    EXPECT_TRUE(std::ranges::any_of(checks, [](const DataCheck &check) {
        return check.id == DataCheck::Id::running && check.remedy.contains(QStringLiteral("J1939"));
    }));
    say(test::canFrame(0x705, {0x7F}));
    bus->advance(2s);
    EXPECT_FALSE(link->sent.empty());
}

TEST_F(CanopenBusFaults, WhereOnlyJ1939IsHeardTheUserMaySendAllTheSame)
{
    connectTo({});
    plant->bus()->add(std::make_shared<test::Talker>());
    open(EncoderBus::Start::watching);
    CanFrame j1939 = test::canFrame(0x0CFFE0E0, {1, 2, 3, 4, 5, 6, 7, 8});
    j1939.isExtended = true;
    say(j1939);
    bus->advance(100ms);
    bus->setOperate(true);
    bus->sendBesideOthers();
    bus->advance(1s);
    EXPECT_FALSE(link->sent.empty());
}

// And of nothing that an encoder sends, however it was set.
TEST_F(CanopenBusFaults, TimeAndTheHeartbeatOfNodeZeroAreSignsOfAnotherMaster)
{
    const auto textOf = [](const CanFrame &frame) {
        OtherMaster master;
        master.take(frame);
        return OtherMaster::textOf(master.argument());
    };
    EXPECT_EQ(textOf(test::canFrame(0x100, {0, 0, 0, 0, 0, 0})), QStringLiteral("TIME"));
    EXPECT_EQ(textOf(test::canFrame(0x700, {0x05})), QStringLiteral("heartbeat of a master"));
    for (const std::uint32_t id : {0x085U, 0x185U, 0x205U, 0x505U, 0x585U, 0x705U, 0x77FU, 0x7E4U})
        EXPECT_EQ(textOf(test::canFrame(id, {0x05})), QString()) << id;
    open(EncoderBus::Start::watching);
    say(test::canFrame(0x700, {0x05}));
    bus->advance(100ms);
    bus->setOperate(true);
    bus->advance(1s);
    EXPECT_TRUE(link->sent.empty());
}

TEST_F(CanopenBusFaults, AnswersToAnotherMasterAreHisAndNotTaken)
{
    open(EncoderBus::Start::watching);
    bus->advance(200ms);
    for (int i = 0; i < 3; ++i)
        say(test::canFrame(0x605, {0x40, 0x04, 0x60, 0, 0, 0, 0, 0}));
    bus->advance(200ms);
    EXPECT_EQ(bus->latest().figures.answersOfOthers, 3U);
    EXPECT_TRUE(bus->latest().otherMaster.isHeard(OtherMaster::Sign::requests));
    EXPECT_FALSE(bus->encoder(five)->latest().position);
}

TEST_F(CanopenBusFaults, ALostHeartbeatIsSaid)
{
    operate(3s);
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setOn(false); });
    bus->advance(6s);
    EXPECT_EQ(countOf(CanopenBusMessageId::heartbeatLost), 1);
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setOn(true); });
    bus->advance(6s);
    EXPECT_EQ(bus->encoder(six)->latest().state, EncoderState::waiting) << "pre-operational";
}

TEST_F(CanopenBusFaults, WhyThereIsNoDataSaysWhatWasHeard)
{
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    const auto pre = difference(six.node);
    ASSERT_TRUE(pre);
    EXPECT_EQ(pre->id, DataCheck::Id::state);
    EXPECT_EQ(pre->came, QStringLiteral("pre-operational"));
    ASSERT_TRUE(bus->add(9, QStringLiteral("canopen-406-multi-turn")));
    bus->advance(10ms);
    const auto missing = difference(NodeId("can:9"));
    ASSERT_TRUE(missing);
    EXPECT_EQ(missing->id, DataCheck::Id::reached);
    EXPECT_EQ(missing->came, QStringLiteral("heard: 5, 6, 7"));
    say(canopen::NmtRequest{canopen::NmtCommand::stop, 6}.frame());
    bus->advance(1500ms);
    const auto stopped = difference(six.node);
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->came, QStringLiteral("stopped"));
}

TEST_F(CanopenBusFaults, AnotherProfileIsNamedAndNothingIsWrittenThere)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].profile = 410;
    connectTo(encoders);
    operate();
    const auto check = difference(six.node);
    ASSERT_TRUE(check);
    EXPECT_EQ(check->id, DataCheck::Id::kind);
    EXPECT_EQ(check->came, QStringLiteral("410 (inclinometers)"));
    EXPECT_EQ(check->expected, QStringLiteral("406 (encoders)"));
    const auto outcome = carryOut(six, SetPreset{.value = 1'000});
    const auto why = outcome && !outcome->result ? std::optional(outcome->result.error()) : refused;
    ASSERT_TRUE(why);
    EXPECT_EQ(why->id, CanopenRefusalId::otherProfile);
    EXPECT_TRUE(refusalText(*why).contains(QStringLiteral("410 (inclinometers)")));
    EXPECT_EQ(std::ranges::count_if(link->sent, isPreset), 0);
}

// Each of these keeps a PDO from coming, and is told with what helps.
struct NoPdoRow
{
    const char *name;
    canopen::SdoObject object;
    std::vector<std::uint8_t> value;
    const char *came;
    const char *helps;
};

const NoPdoRow noPdoRows[] = {
    {"as delivered", {0x1800, 5}, {0, 0}, "none: the shaft is at rest", "1800h:5"},
    {"bit 31", {0x1800, 1}, {0x85, 1, 0, 0x80}, "TPDO1 is switched off", "1800h:1"},
    {"each SYNC", {0x1800, 2}, {1}, "TPDO1 waits for SYNC", "1800h:2"},
    {"remote frames", {0x1800, 2}, {253}, "TPDO1 waits to be asked for", "1800h:2"},
};

TEST_F(CanopenBusFaults, WhyNoPdoComesIsSaid)
{
    for (const NoPdoRow &row : noPdoRows) {
        connectTo(canopen::trainingEncoders());
        operate();
        bus->transfer({.node = 5, .object = row.object, .value = row.value});
        bus->advance(200ms);
        bus->close();
        operate(6s);
        const DataChecks checks = bus->dataChecks(five.node, {});
        const auto pdo = std::ranges::find(checks, QStringLiteral("Positions by PDO"), &DataCheck::what);
        ASSERT_NE(pdo, checks.end()) << row.name;
        EXPECT_EQ(pdo->outcome, DataCheck::Outcome::remark) << row.name; // it is asked for
        EXPECT_EQ(pdo->came.toStdString(), row.came);
        EXPECT_TRUE(pdo->remedy.contains(QLatin1String(row.helps))) << pdo->remedy.toStdString();
    }
}

TEST_F(CanopenBusFaults, SyncCountsOnlyAsLongAsItGoesOn)
{
    operate();
    bus->transfer({.node = 5, .object = {0x1800, 2}, .value = std::vector<std::uint8_t>{1}});
    bus->advance(500ms);
    const auto waits = [this] {
        const DataChecks checks = bus->dataChecks(five.node, {});
        const auto pdo = std::ranges::find(checks, QStringLiteral("Positions by PDO"), &DataCheck::what);
        return pdo != checks.end() && pdo->came == QStringLiteral("TPDO1 waits for SYNC");
    };
    EXPECT_TRUE(waits());
    for (const Instant period : {100ms, 2000ms}) {
        for (int i = 0; i < 3; ++i) {
            say(canopen::syncFrame());
            bus->advance(period);
        }
        EXPECT_FALSE(waits());
        bus->advance(4 * period + 1s);
        EXPECT_TRUE(waits()) << "it has ended";
    }
}

TEST_F(CanopenBusFaults, PdosUnderUnusualTermsAreNoted)
{
    const auto operateStarted = [this] {
        operate(3s);
        bus->send(test::canFrame(0, {1, 5}));
        bus->advance(1s);
    };
    operate();
    bus->transfer({.node = 5, .object = {0x1800, 5}, .value = std::vector<std::uint8_t>{50, 0}});
    bus->advance(200ms);
    bus->close();
    operateStarted();
    const auto pdo = [&] {
        const DataChecks checks = bus->dataChecks(five.node, {});
        return *std::ranges::find(checks, QStringLiteral("Positions by PDO"), &DataCheck::what);
    };
    EXPECT_EQ(pdo().outcome, DataCheck::Outcome::asExpected) << pdo().remedy.toStdString();
    bus->transfer({.node = 5, .object = {0x1800, 3}, .value = std::vector<std::uint8_t>{0xD0, 7}}); // 200 ms
    bus->advance(200ms);
    bus->close();
    operateStarted();
    EXPECT_EQ(pdo().outcome, DataCheck::Outcome::remark);
    EXPECT_TRUE(pdo().remedy.startsWith(QStringLiteral("Positions come each 200 ms at the most")))
        << pdo().remedy.toStdString();
}

// It can be started, and the shaft is not what is missing.
TEST_F(CanopenBusFaults, ThatANodeIsPreOperationalIsTheReasonThatNoPdoComes)
{
    operate();
    bus->transfer({.node = 6, .object = {0x1800, 5}, .value = std::vector<std::uint8_t>{50, 0}});
    bus->advance(200ms);
    bus->close();
    operate(3s);
    const auto outcomes = [this] {
        const DataChecks checks = bus->dataChecks(six.node, {});
        const auto of = [&](const char *what) {
            return *std::ranges::find(checks, QLatin1String(what), &DataCheck::what);
        };
        return std::pair(of("State of the node"), of("Positions by PDO"));
    };
    EXPECT_EQ(outcomes().first.outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(outcomes().second.outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(outcomes().second.came, QStringLiteral("none: the node is pre-operational"));
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 6}.frame());
    bus->advance(2s);
    EXPECT_EQ(outcomes().first.outcome, DataCheck::Outcome::asExpected);
    EXPECT_EQ(outcomes().second.outcome, DataCheck::Outcome::asExpected);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::preOperational, 6}.frame());
    bus->advance(2s);
    EXPECT_EQ(outcomes().first.outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(outcomes().second.outcome, DataCheck::Outcome::remark);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 6}.frame());
    bus->advance(2s);
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setOn(false); });
    bus->advance(1'500ms);
    EXPECT_NE(outcomes().second.outcome, DataCheck::Outcome::asExpected) << "they came";
}

// It keeps those of the number it had before.
TEST_F(CanopenBusFaults, IdentifiersThatAreNotThoseOfTheNumberAreNamed)
{
    auto encoders = canopen::trainingEncoders();
    encoders[1].quirks.keepsIdentifiers = true;
    connectTo(encoders);
    operate(1s);
    bus->transfer(
        {.node = 6, .object = {0x1010, 1}, .value = std::vector<std::uint8_t>{0x73, 0x61, 0x76, 0x65}});
    bus->transfer({.node = 6, .object = {0x2000, 0}, .value = std::vector<std::uint8_t>{9}});
    bus->transfer(
        {.node = 6, .object = {0x1010, 1}, .value = std::vector<std::uint8_t>{0x73, 0x61, 0x76, 0x65}});
    bus->advance(1s);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::resetNode, 6}.frame());
    ASSERT_TRUE(bus->add(9, QStringLiteral("canopen-406-multi-turn")));
    bus->advance(3s);
    const DataChecks checks = bus->dataChecks(NodeId("can:9"), {});
    const auto check =
        std::ranges::find(checks, QStringLiteral("Identifier of 1014h:0 (EMCY)"), &DataCheck::what);
    ASSERT_NE(check, checks.end());
    EXPECT_EQ(check->outcome, DataCheck::Outcome::remark);
    EXPECT_EQ(check->expected, QStringLiteral("089h"));
    EXPECT_EQ(check->came, QStringLiteral("086h"));
    EXPECT_EQ(countOf(CanopenMessageId::identifierKept), 3) << "and two PDOs";
}

// Node 5 has no heartbeat that would tell.
TEST_F(CanopenBusFaults, WhyNothingNewComesOfAStoppedNodeOrInWatchIsSaid)
{
    operate();
    bus->transfer({.node = 5, .object = {0x1017, 0}, .value = std::vector<std::uint8_t>{0, 0}});
    bus->advance(500ms);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 5}.frame());
    bus->advance(10s);
    EXPECT_EQ(bus->encoder(five)->freshness().reason(), Freshness::Reason::nodeStopped);
    const auto stopped = difference(five.node);
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->came, QStringLiteral("stopped (as commanded)"));
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 5}.frame());
    bus->advance(2s);
    EXPECT_TRUE(bus->encoder(five)->freshness().isLive());
    bus->send(canopen::NmtRequest{canopen::NmtCommand::preOperational, 5}.frame());
    bus->advance(200ms);
    bus->setOperate(false);
    bus->advance(10s);
    EXPECT_EQ(bus->encoder(five)->freshness().reason(), Freshness::Reason::watched);
    bus->setOperate(true);
    bus->advance(1s);
    say(test::canFrame(0x80, {}));
    bus->advance(10s);
    EXPECT_EQ(bus->encoder(five)->freshness().reason(), Freshness::Reason::heldBack);
}

TEST_F(CanopenBusFaults, ManyErrorFramesAreNotedThoughFramesCome)
{
    operate();
    const auto frames = [this] {
        const DataChecks checks = bus->dataChecks(six.node, {});
        return *std::ranges::find(checks, QStringLiteral("Frames"), &DataCheck::what);
    };
    EXPECT_EQ(frames().outcome, DataCheck::Outcome::asExpected);
    plant->bus()->setFaults({.damaged = 300});
    bus->advance(30s);
    EXPECT_EQ(frames().outcome, DataCheck::Outcome::remark);
    EXPECT_TRUE(frames().remedy.startsWith(QStringLiteral("Error frames: ")))
        << frames().remedy.toStdString();
}

TEST_F(CanopenBusFaults, NobodyThereIsSaid)
{
    connectTo({});
    plant->bus()->remove(*talker);
    open(EncoderBus::Start::watching);
    bus->advance(1s);
    EXPECT_EQ(difference()->came, QStringLiteral("none"));
    bus->setOperate(true);
    bus->advance(1s);
    EXPECT_EQ(difference()->came, QStringLiteral("nobody acknowledges what is sent"));
}

TEST_F(CanopenBusFaults, J1939IsSaid)
{
    connectTo({});
    open(EncoderBus::Start::watching);
    CanFrame frame = test::canFrame(0x0CFF'E0E0, {1, 2, 3, 4, 5, 6, 7, 8});
    frame.isExtended = true;
    say(frame);
    bus->advance(10ms);
    EXPECT_EQ(difference()->came, QStringLiteral("only errors")) << "nobody acknowledges it";
    bus->setOperate(true);
    bus->advance(100ms);
    EXPECT_EQ(bus->latest().figures.extended, 1U);
    EXPECT_EQ(difference()->came, QStringLiteral("J1939"));
}

} // namespace
} // namespace codewheel
