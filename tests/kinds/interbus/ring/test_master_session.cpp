// SPDX-License-Identifier: GPL-3.0-or-later
// How the session handles the ring's master, on a simulated ring in virtual time.
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/words/profiles.h"
#include "tests/support/faulty_ring.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"
#include "vocabulary/refusal_text.h"

#include <QPointer>

#include <array>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;

const Place first = "1.0"_ring;
const Place second = "2.0"_ring;
const Place onLocalBus = "3.1"_ring;
const Place last = "6.0"_ring;

class ASessionWithAMaster : public testing::Test
{
protected:
    ASessionWithAMaster()
    {
        QObject::connect(&m_bus, &RingSession::messaged, &m_bus,
                         [this](const Message &message) { m_messages.push_back(message); });
        QObject::connect(&m_bus, &RingSession::readInProgressed, &m_bus,
                         [this](int devices) { m_progress.push_back(devices); });
        QObject::connect(&m_bus, &RingSession::readInEnded, &m_bus, [this] { ++m_readIns; });
        QObject::connect(&m_bus, &RingSession::readInFailed, &m_bus,
                         [this](const Refusal &why) { m_failure = why.id; });
        QObject::connect(&m_bus, &RingSession::structureChanged, &m_bus, [this] { ++m_changes; });
        EXPECT_TRUE(m_bus.open(RingSession::Start::operating));
        m_bus.advance(10);
    }
    void cause(TrainingFault fault, Place place, int value = 1)
    {
        m_ring.ring->setFault(fault, place.node, value);
    }
    std::vector<MessageCode> takeMessages()
    {
        std::vector<MessageCode> ids;
        for (const Message &message : std::exchange(m_messages, {}))
            ids.push_back(message.id);
        return ids;
    }
    EncoderState stateOf(Place number) const { return m_bus.encoder(number)->latest().state; }
    void readIn()
    {
        m_bus.readIn();
        m_bus.advance(static_cast<int>(FaultyRing::devices) + 5);
    }

    const Catalog m_catalog = Catalog::builtIn();
    FaultyRing m_ring;
    RingSession m_bus{std::move(m_ring.link), m_catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    std::vector<Message> m_messages;
    std::vector<int> m_progress;
    int m_readIns = 0;
    int m_changes = 0;
    std::optional<RefusalCode> m_failure;
};

// Pending events still reach the other encoders; the named encoder gets its rows and its EEPROM writes, but
// nothing that the previous driver has learned.
TEST_F(ASessionWithAMaster, NamingTakesNothingFromTheEventsOfOthers)
{
    const auto send = [this](Word word) {
        for (const Place place : {first, second}) {
            m_bus.channel(place)->stage(word);
            ASSERT_TRUE(m_bus.channel(place)->write());
        }
    };
    for (const Place place : {first, second})
        m_bus.encoder(place)->tell(Parameter::startUpMode, 1);
    send(0x0400'0002);
    m_bus.advance(50);
    send(0x8000'0000);
    std::map<Place, int> rows;
    const auto follow = [&](Place place) {
        QObject::connect(m_bus.encoder(place), &EncoderSession::exchanged, &m_bus,
                         [&rows, place] { ++rows[place]; });
    };
    follow(second);
    bool isNamed = false;
    QObject::connect(m_bus.encoder(first), &EncoderSession::latestChanged, &m_bus, [&] {
        if (!std::exchange(isNamed, true)) {
            EncoderSession *before = m_bus.encoder(first);
            ASSERT_TRUE(m_bus.name(first, QStringLiteral("fraba-ocd-ib")));
            follow(first);
            const auto started = before->start(ReadParameters{{Parameter::steps}});
            ASSERT_FALSE(started) << "nobody would tell its end";
            EXPECT_EQ(started.error().id, RingRefusalId::notInRing);
        }
    });
    m_bus.advance(500); // one frame, with everything that has happened
    EXPECT_TRUE(isNamed);
    EXPECT_GT(rows[first], 0);
    EXPECT_EQ(rows[first], rows[second]);
    EXPECT_EQ(m_bus.encoder(first)->known(Parameter::revolutions), std::nullopt);
    EXPECT_EQ(m_bus.encoder(first)->eepromWrites(), 1);
    ASSERT_TRUE(m_bus.encoder(second)->known(Parameter::revolutions));
    EXPECT_EQ(m_bus.encoder(second)->known(Parameter::revolutions)->value, 2);
    EXPECT_EQ(m_bus.encoder(second)->eepromWrites(), 1);
}

TEST_F(ASessionWithAMaster, SaysOnConnectingWhichConfigurationTheMasterKeeps)
{
    EXPECT_EQ(m_messages.front().id, RingMessageId::configurationFound);
    EXPECT_EQ(m_messages.front().arguments,
              (std::vector<RefusalArgument>{QStringLiteral("plant.codewheel"), std::int64_t{8}}));
    ASSERT_NE(m_bus.master(), nullptr);
    EXPECT_EQ(m_bus.master()->statusBits, 0x00E0);
}

TEST_F(ASessionWithAMaster, StopsAndStartsByTheMaster)
{
    m_bus.setRunning(false);
    m_bus.advance(1);
    EXPECT_EQ(m_bus.master()->statusBits, 0x00C0);
    EXPECT_EQ(m_bus.latest().state, MasterState::active);
    m_bus.setRunning(true);
    m_bus.advance(1);
    EXPECT_EQ(m_bus.master()->statusBits, 0x00E0);
    EXPECT_TRUE(m_bus.isRunning());
}

TEST_F(ASessionWithAMaster, AlarmStopZeroesTheRingAndTakesItToReady)
{
    m_bus.channel(first)->stage(0x0200'00FF);
    ASSERT_TRUE(m_bus.channel(first)->write());
    m_bus.advance(5);
    ASSERT_EQ(m_ring.ring->lastOut()[0], 0x0200'00FFU);
    m_bus.alarmStop();
    m_bus.advance(1);
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
    EXPECT_EQ(m_ring.ring->lastOut(), std::vector<Word>(FaultyRing::devices));
    EXPECT_EQ(m_bus.channel(first)->out(), 0U);
    m_bus.setRunning(true);
    m_bus.advance(3);
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_EQ(m_ring.ring->lastOut()[0], 0U);
}

TEST_F(ASessionWithAMaster, ABrokenWireStopsTheRingIsNamedAndIsStartedAgainByTheUser)
{
    m_bus.channel(first)->stage(0x0200'00FF);
    ASSERT_TRUE(m_bus.channel(first)->write());
    m_bus.advance(5);
    takeMessages();
    cause(TrainingFault::wireBreak, second);
    m_bus.advance(1);
    EXPECT_EQ(m_bus.latest().state, MasterState::busFail);
    EXPECT_EQ(m_bus.channel(first)->out(), 0U);
    m_bus.advance(40);
    ASSERT_EQ(m_messages.size(), 2U);
    EXPECT_EQ(messageText(m_messages[0]).toStdString(),
              "Bus fault: 0BDF – the master is looking for the fault.");
    EXPECT_EQ(messageText(m_messages[1]).toStdString(),
              "Bus fault: 0D10 at outgoing remote bus of 1.0 (see IBS SYS FW G4 UM).");
    EXPECT_EQ(m_messages[1].place, first);
    EXPECT_TRUE(m_bus.latest().devices[0].inRing);
    EXPECT_FALSE(m_bus.latest().devices[1].inRing);
    takeMessages();

    m_bus.setRunning(true); // too early
    m_bus.advance(1);
    EXPECT_EQ(m_messages.back().refusal->id, RingRefusalId::busFault);
    EXPECT_EQ(m_bus.latest().state, MasterState::busFail);

    takeMessages();
    cause(TrainingFault::wireBreak, second, 0);
    m_bus.advance(5);
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::busFaultGone));
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
    m_bus.setRunning(true);
    m_bus.advance(3);
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_EQ(m_bus.channel(first)->out(), 0U); // what was there is not sent again by itself
    EXPECT_EQ(stateOf(second), EncoderState::operation);
}

TEST_F(ASessionWithAMaster, AWordBehindAFaultIsTheLastOneWithItsAge)
{
    m_bus.advance(500);
    const Word in = m_bus.channel(second)->in();
    const Instant seen = m_bus.latest().at;
    ASSERT_NE(in, 0U);
    cause(TrainingFault::wireBreak, second);
    m_bus.advance(40);
    const Freshness &freshness = m_bus.channel(second)->freshness();
    EXPECT_EQ(freshness.reason(), Freshness::Reason::notOnBus);
    EXPECT_EQ(freshness.seen(), seen);
    EXPECT_EQ(m_bus.channel(second)->in(), in);
    EXPECT_FALSE(m_bus.encoder(second)->latest().position) << "nobody takes it for a position";
}

TEST_F(ASessionWithAMaster, AJobEndsAsStoppedWhenTheBusFails)
{
    std::optional<Outcome> outcome;
    QObject::connect(m_bus.encoder(first), &EncoderSession::finished, &m_bus,
                     [&](const Outcome &ended) { outcome = ended; });
    ASSERT_TRUE(m_bus.encoder(first)->start(ReadParameters{{Parameter::steps}}));
    m_bus.advance(2);
    cause(TrainingFault::noSupply, last);
    m_bus.advance(1);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result.error().id, RefusalId::busStopped);
}

TEST_F(ASessionWithAMaster, ASegmentThatIsOffHasNoReadingAndIsSentNothing)
{
    EXPECT_EQ(stateOf(onLocalBus), EncoderState::operation);
    takeMessages();
    m_bus.switchSegment(3, false);
    m_bus.advance(2);
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::segmentOff));
    EXPECT_EQ(stateOf(onLocalBus), EncoderState::notSeen);
    EXPECT_EQ(stateOf(first), EncoderState::operation);
    const auto refused = m_bus.encoder(onLocalBus)->start(ReadParameters{{Parameter::steps}});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, RingRefusalId::notInRing);
    m_bus.channel(last)->stage(1);
    EXPECT_FALSE(m_bus.channel(last)->write());
    m_bus.switchSegment(3, true);
    m_bus.advance(2);
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::segmentOn));
    EXPECT_EQ(stateOf(onLocalBus), EncoderState::operation);
}

TEST_F(ASessionWithAMaster, AJobInASegmentThatIsSwitchedOffEndsAsStopped)
{
    std::optional<Outcome> outcome;
    QObject::connect(m_bus.encoder(last), &EncoderSession::finished, &m_bus,
                     [&](const Outcome &ended) { outcome = ended; });
    ASSERT_TRUE(m_bus.encoder(last)->start(ReadParameters{{Parameter::steps}}));
    m_bus.advance(2);
    m_bus.switchSegment(6, false);
    m_bus.advance(1);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result.error().id, RefusalId::busStopped);
    EXPECT_FALSE(m_bus.latest().devices[7].heldByJob);
}

TEST_F(ASessionWithAMaster, APeripheralFaultIsToldAgainWhereItsCauseIsThereWhenItIsConfirmed)
{
    cause(TrainingFault::peripheralFault, onLocalBus);
    takeMessages();
    m_bus.advance(1);
    ASSERT_EQ(m_messages.size(), 1U);
    EXPECT_EQ(messageText(m_messages[0]).toStdString(),
              "Fault: 0BB1 – peripheral fault at 3.1. Confirm it when its cause is gone.");
    EXPECT_EQ(m_bus.master()->faultText().toStdString(), "0BB1 – peripheral fault at 3.1");
    EXPECT_TRUE(m_bus.isRunning());
    takeMessages();
    m_bus.confirmDiagnostics();
    m_bus.advance(2);
    EXPECT_THAT(takeMessages(),
                ElementsAre(RingMessageId::diagnosticsConfirmed, RingMessageId::peripheralFaultConfirmed,
                            RingMessageId::peripheralFault));
    cause(TrainingFault::peripheralFault, onLocalBus, 0);
    m_bus.confirmDiagnostics();
    m_bus.advance(2);
    EXPECT_THAT(takeMessages(),
                ElementsAre(RingMessageId::diagnosticsConfirmed, RingMessageId::peripheralFaultConfirmed));
    EXPECT_FALSE(m_bus.master()->isFaulty());
}

TEST_F(ASessionWithAMaster, APeripheralFaultIsNotConfirmedByReadingIn)
{
    cause(TrainingFault::peripheralFault, onLocalBus);
    m_bus.advance(1);
    cause(TrainingFault::peripheralFault, onLocalBus, 0);
    takeMessages();
    readIn();
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::ringRead, MessageId::busStarted));
    EXPECT_TRUE(m_bus.master()->isFaulty());
    m_bus.confirmDiagnostics();
    m_bus.advance(2);
    EXPECT_THAT(takeMessages(),
                ElementsAre(RingMessageId::diagnosticsConfirmed, RingMessageId::peripheralFaultConfirmed));
}

TEST_F(ASessionWithAMaster, InAnotherRingAPeripheralFaultIsToldByItsNewNumber)
{
    cause(TrainingFault::peripheralFault, last);
    m_bus.advance(1);
    cause(TrainingFault::wireBreak, "4.0"_ring);
    m_bus.advance(30);
    m_messages.clear();
    readIn();
    m_bus.advance(5);
    const auto told = std::ranges::find(m_messages, RingMessageId::peripheralFault, &Message::id);
    ASSERT_NE(told, m_messages.end());
    EXPECT_EQ(told->place, ("4.0"_ring));
    EXPECT_EQ(std::ranges::count(m_messages, RingMessageId::peripheralFault, &Message::id), 1);
    EXPECT_EQ(std::ranges::count(m_messages, RingMessageId::peripheralFaultConfirmed, &Message::id), 0);
}

TEST_F(ASessionWithAMaster, AFaultInASegmentThatIsSwitchedOffIsNotToldAsGone)
{
    cause(TrainingFault::wireBreak, "5.0"_ring);
    m_bus.advance(30);
    takeMessages();
    m_bus.switchSegment(4, false); // the segment before 5.0
    m_bus.advance(3);
    ASSERT_EQ(m_messages.size(), 2U);
    EXPECT_EQ(m_messages[0].id, RingMessageId::segmentOff);
    EXPECT_EQ(
        messageText(m_messages[1]).toStdString(),
        "Segment 4 is switched off, and the place of the bus fault with it: 0D10 at outgoing remote bus "
        "of 4.0 (see IBS SYS FW G4 UM). The fault may still be there. Start the bus again.");
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
}

TEST_F(ASessionWithAMaster, AFaultElsewhereIsToldAsGone)
{
    m_bus.switchSegment(4, false);
    cause(TrainingFault::wireBreak, last);
    m_bus.advance(30);
    takeMessages();
    cause(TrainingFault::wireBreak, last, 0);
    m_bus.advance(3);
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::busFaultGone));
}

TEST_F(ASessionWithAMaster, ReadingInARingWhereNoDeviceAnswersIsToldInWords)
{
    cause(TrainingFault::wireBreak, first);
    m_bus.advance(30);
    m_messages.clear();
    readIn();
    ASSERT_EQ(m_messages.size(), 1U);
    EXPECT_EQ(m_messages[0].severity, Severity::attention);
    EXPECT_EQ(messageText(m_messages[0]).toStdString(),
              "No device answered when the ring was read in. Check the cable to the first device, and its "
              "supply.");
}

TEST_F(ASessionWithAMaster, CrcErrorsOfABurstAreToldWhenTheirMinuteIsOver)
{
    cause(TrainingFault::crcErrors, second, 100);
    takeMessages();
    m_bus.advance(5'000);
    cause(TrainingFault::crcErrors, second, 0);
    m_bus.advance(100'000);
    ASSERT_EQ(m_messages.size(), 2U);
    const std::int64_t all = m_bus.master()->segments[1].crcErrors;
    EXPECT_GT(all, 300);
    EXPECT_EQ(m_messages[1].arguments, (std::vector<RefusalArgument>{std::int64_t{2}, all - 1, all}));
    EXPECT_EQ(m_messages[1].at, m_messages[0].at + 60s);
    EXPECT_EQ(m_messages[1].place, second);
}

TEST_F(ASessionWithAMaster, CrcErrorsAreToldWhenTheBusIsStoppedWithinTheMinute)
{
    cause(TrainingFault::crcErrors, second, 100);
    takeMessages();
    m_bus.advance(500);
    const std::int64_t all = m_bus.master()->segments[1].crcErrors;
    ASSERT_GT(all, 10);
    m_bus.setRunning(false);
    m_bus.setRunning(true); // which restarts the counts
    m_bus.advance(1);
    ASSERT_GE(m_messages.size(), 2U);
    EXPECT_EQ(m_messages[1].id, MessageId::crcErrors);
    EXPECT_EQ(m_messages[1].arguments, (std::vector<RefusalArgument>{std::int64_t{2}, all - 1, all}));
}

TEST_F(ASessionWithAMaster, CrcErrorsAreToldOnceAMinute)
{
    cause(TrainingFault::crcErrors, second, 100);
    takeMessages();
    m_bus.advance(59'000);
    ASSERT_EQ(m_messages.size(), 1U);
    EXPECT_EQ(m_messages[0].arguments[0], RefusalArgument(std::int64_t{2}));
    m_bus.advance(2'000);
    ASSERT_EQ(m_messages.size(), 2U);
    EXPECT_GT(std::get<std::int64_t>(m_messages[1].arguments[1]), 5'000);
}

TEST_F(ASessionWithAMaster, ReadingInTheSameRingKeepsAllAndRunsAgain)
{
    QPointer<EncoderSession> before = m_bus.encoder(first);
    before->tell(Parameter::steps, 4'096);
    takeMessages();
    m_bus.readIn();
    EXPECT_TRUE(m_bus.isReadingIn());
    m_bus.advance(3);
    EXPECT_THAT(m_progress, ElementsAre(1, 2, 3));
    EXPECT_FALSE(m_bus.isRunning());
    m_bus.advance(10);
    EXPECT_FALSE(m_bus.isReadingIn());
    EXPECT_EQ(m_progress.back(), 8);
    EXPECT_EQ(m_readIns, 1);
    EXPECT_EQ(m_changes, 0);
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_EQ(m_bus.encoder(first), before);
    EXPECT_EQ(before->known(Parameter::steps)->value, 4'096);
    EXPECT_THAT(takeMessages(), ElementsAre(RingMessageId::ringRead, MessageId::busStarted));
}

TEST_F(ASessionWithAMaster, ReadingInAnotherRingKeepsWhatIsUnchanged)
{
    QPointer<EncoderSession> kept = m_bus.encoder(first);
    QPointer<WordChannel> channel = m_bus.channel(first);
    QPointer<EncoderSession> gone = m_bus.encoder(last);
    ASSERT_TRUE(kept->start(ReadParameters{{Parameter::steps}}));
    m_bus.advance(200);
    ASSERT_EQ(kept->known(Parameter::steps)->value, 8'192);
    cause(TrainingFault::wireBreak, "3.1"_ring);
    m_bus.advance(30);
    readIn();
    EXPECT_EQ(m_changes, 1);
    EXPECT_EQ(m_readIns, 1);
    m_bus.advance(5);
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_TRUE(m_bus.isOperating());
    EXPECT_THAT(m_bus.places(), ElementsAre(first, second, "3.0"_ring, "4.0"_ring, "5.0"_ring, last));
    EXPECT_EQ(m_bus.encoder(first), kept);
    EXPECT_EQ(m_bus.channel(first), channel);
    EXPECT_EQ(kept->device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(kept->known(Parameter::steps)->value, 8'192);
    // 6.0 has kept its session at another place of the process image.
    EXPECT_EQ(m_bus.encoder(last), gone);
    EXPECT_EQ(gone->latest().in, 6'000U);
    EXPECT_EQ(m_bus.encoder(onLocalBus), nullptr);
    ASSERT_TRUE(gone->start(ReadParameters{{Parameter::steps}}));
    m_bus.advance(200);
    EXPECT_EQ(gone->known(Parameter::steps)->value, 8'192);
}

// A handler may still look at a vanished device while the rings change, but sends nothing with it: its place
// in the process image may belong to another device.
TEST_F(ASessionWithAMaster, WhatVanishedOutlivesTheHandlersAndSendsNothing)
{
    const QPointer<WordChannel> channel = m_bus.channel(onLocalBus);
    const QPointer<EncoderSession> session = m_bus.encoder(onLocalBus);
    std::optional<RefusalCode> refusedWrite;
    std::optional<RefusalCode> refusedJob;
    QObject::connect(channel, &WordChannel::refused, &m_bus,
                     [&](const Refusal &why) { refusedWrite = why.id; });
    QObject::connect(&m_bus, &RingSession::structureChanged, &m_bus, [&] {
        ASSERT_NE(channel, nullptr);
        ASSERT_NE(session, nullptr);
        EXPECT_EQ(channel->place(), onLocalBus);
        channel->stage(0x0200'00FF);
        EXPECT_FALSE(channel->write());
        session->tell(Parameter::steps, 4'096);
        const auto started =
            session->start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}});
        ASSERT_FALSE(started);
        refusedJob = started.error().id;
    });
    cause(TrainingFault::wireBreak, onLocalBus);
    m_bus.advance(30);
    readIn();
    ASSERT_EQ(m_changes, 1);
    EXPECT_EQ(refusedWrite, RingRefusalId::notInRing);
    EXPECT_EQ(refusedJob, RingRefusalId::notInRing);
    m_bus.advance(100);
    EXPECT_EQ(channel, nullptr);
    EXPECT_EQ(session, nullptr);
    EXPECT_EQ(m_ring.ring->lastOut(), std::vector<Word>(m_bus.structure().size()));
    EXPECT_EQ(m_bus.encoder("4.0"_ring)->known(Parameter::steps), std::nullopt) << "it has its place now";
}

TEST_F(ASessionWithAMaster, AnotherDeviceInAPlaceGetsASessionOfItsOwn)
{
    QPointer<EncoderSession> before = m_bus.encoder(second);
    cause(TrainingFault::wrongDevice, second);
    m_bus.advance(30);
    readIn();
    m_bus.advance(1);
    EXPECT_EQ(before, nullptr);
    ASSERT_NE(m_bus.encoder(second), nullptr);
    EXPECT_EQ(m_bus.encoder(second)->device().profile, profile::k2);
}

TEST_F(ASessionWithAMaster, AlarmStopEndsReadingIn)
{
    m_bus.readIn();
    m_bus.advance(3);
    m_bus.alarmStop();
    m_bus.advance(20);
    EXPECT_EQ(m_failure, RefusalId::alarmStop);
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
    EXPECT_FALSE(m_bus.isReadingIn());
}

// Posted while the ring that was read in takes over: the new one must not start.
TEST_F(ASessionWithAMaster, AlarmStopBetweenTwoRingsIsNotLost)
{
    cause(TrainingFault::wireBreak, last);
    m_bus.advance(30);
    QObject::connect(&m_bus, &RingSession::readInProgressed, &m_bus, [this](int devices) {
        if (devices == 7)
            m_bus.alarmStop();
    });
    readIn();
    m_bus.advance(5);
    EXPECT_EQ(m_changes, 1);
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
    EXPECT_FALSE(m_bus.isRunning());
}

TEST_F(ASessionWithAMaster, TheMasterKeepsWhatItIsGiven)
{
    std::optional<KeptConfiguration> told;
    QObject::connect(&m_bus, &RingSession::keptConfigurationTold, &m_bus,
                     [&](const std::optional<KeptConfiguration> &kept) { told = kept; });
    const KeptConfiguration mine{QStringLiteral("mine.codewheel"), m_bus.structure()};
    m_bus.keepConfiguration(mine);
    m_bus.advance(1);
    EXPECT_EQ(told, mine);
    EXPECT_EQ(m_bus.master()->configurationName, QStringLiteral("mine.codewheel"));
    told.reset();
    m_bus.close();
    ASSERT_TRUE(m_bus.open(RingSession::Start::watching));
    takeMessages();
    m_bus.advance(1);
    EXPECT_THAT(takeMessages(), Contains(RingMessageId::configurationFound));
    EXPECT_EQ(told, mine);
}

// A configuration smaller than the one the ring was started with takes its place.
TEST_F(ASessionWithAMaster, AConfigurationThatIsActivatedAnewIsTakenOver)
{
    cause(TrainingFault::wireBreak, last);
    m_bus.advance(30);
    KeptConfiguration smaller{QStringLiteral("smaller.codewheel"), m_bus.structure()};
    smaller.structure.pop_back();
    m_bus.keepConfiguration(smaller);
    m_bus.setRunning(true);
    m_bus.advance(3);
    EXPECT_EQ(m_changes, 1);
    m_bus.advance(3);
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_EQ(m_bus.structure().size(), 7U);
}

TEST_F(ASessionWithAMaster, InWatchNothingChangesWhatTheRingDoesButStop)
{
    m_bus.setOperate(false);
    m_bus.advance(2);
    const KeptConfiguration other{QStringLiteral("other.codewheel"), m_bus.structure()};
    const std::array<std::function<void()>, 4> services{
        [&] { m_bus.readIn(); }, [&] { m_bus.switchSegment(6, false); }, [&] { m_bus.confirmDiagnostics(); },
        [&] { m_bus.keepConfiguration(other); }};
    for (const auto &service : services) {
        m_messages.clear();
        service();
        m_bus.advance(3);
        ASSERT_EQ(m_messages.size(), 1U);
        ASSERT_TRUE(m_messages.front().refusal);
        EXPECT_EQ(m_messages.front().refusal->id, RefusalId::watchOnly);
    }
    EXPECT_EQ(m_failure, RefusalId::watchOnly) << "of reading in";
    EXPECT_FALSE(m_bus.isReadingIn());
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_TRUE(m_bus.latest().devices.back().inRing);
    EXPECT_EQ(m_bus.master()->configurationName, QStringLiteral("plant.codewheel"));
    m_bus.setRunning(false);
    m_bus.advance(2);
    EXPECT_FALSE(m_bus.isRunning());
    m_bus.alarmStop();
    m_bus.advance(2);
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
}

TEST(ASessionWithoutAMaster, RefusesItsServicesInWords)
{
    const Catalog catalog = Catalog::builtIn();
    RingSession bus(std::make_unique<ScriptedLink>(2), catalog, QDateTime());
    std::vector<Message> messages;
    bool failed = false;
    QObject::connect(&bus, &RingSession::messaged, &bus,
                     [&](const Message &message) { messages.push_back(message); });
    QObject::connect(&bus, &RingSession::readInFailed, &bus, [&] { failed = true; });
    ASSERT_TRUE(bus.open(RingSession::Start::watching));
    bus.advance(1);
    EXPECT_EQ(bus.master(), nullptr);
    messages.clear();
    bus.readIn();
    bus.switchSegment(1, false);
    bus.confirmDiagnostics();
    bus.askKeptConfiguration();
    bus.advance(1);
    EXPECT_TRUE(failed);
    EXPECT_FALSE(bus.isReadingIn());
    ASSERT_EQ(messages.size(), 4U);
    for (const Message &message : messages)
        EXPECT_EQ(message.refusal->id, RingRefusalId::masterServiceNotSupported);
    EXPECT_TRUE(bus.isRunning());
}

// The bus in its own thread, faults from another, and the ring read in again and again.
TEST(ASessionInThreads, TakesOtherRingsOver)
{
    const Catalog catalog = Catalog::builtIn();
    FaultyRing faulty;
    RingSession bus(std::move(faulty.link), catalog, QDateTime());
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    int readIns = 0;
    QObject::connect(&bus, &RingSession::readInEnded, &bus, [&] { ++readIns; });
    bus.startThread(100us);
    std::jthread trainer([ring = faulty.ring](const std::stop_token &stop) {
        for (int i = 0; !stop.stop_requested(); ++i) {
            ring->setFault(TrainingFault::wireBreak, i % 3 == 0 ? last.node : second.node, i % 2);
            ring->setFault(TrainingFault::peripheralFault, first.node, i % 5 == 0);
            std::ignore = ring->places();
            std::this_thread::sleep_for(2ms);
        }
    });
    for (int wanted = 1; wanted <= 10; ++wanted) {
        bus.readIn();
        for (int waits = 0; readIns < wanted && waits < 20'000; ++waits) {
            bus.pump();
            if (!bus.isReadingIn() && readIns < wanted)
                bus.readIn();
            std::this_thread::sleep_for(1ms);
        }
        ASSERT_GE(readIns, wanted);
        bus.confirmDiagnostics();
        bus.alarmStop();
    }
    trainer.request_stop();
    trainer.join();
    bus.close();
    EXPECT_EQ(bus.latest().state, MasterState::ready);
}

} // namespace
} // namespace codewheel
