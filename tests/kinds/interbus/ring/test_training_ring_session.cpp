// SPDX-License-Identifier: GPL-3.0-or-later
// The main job below the window: session, runner, driver, simulated encoder.
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/places.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

namespace codewheel {
namespace {

const Place firstFraba = "1.0"_ring;

// A computer that sleeps once, right after somebody has begun to watch it.
SleepWatch::Slept oneSleepOf(std::chrono::milliseconds duration)
{
    return [duration, isWatched = false]() mutable {
        return std::exchange(isWatched, true) ? duration : std::chrono::milliseconds(0);
    };
}

class TrainingBusSession : public testing::Test
{
protected:
    TrainingBusSession()
    {
        EXPECT_TRUE(m_bus.open(RingSession::Start::operating));
        QObject::connect(m_bus.encoder(firstFraba), &EncoderSession::finished, &m_bus,
                         [this](const Outcome &outcome) { m_outcome = outcome; });
        encoder().tell(Parameter::startUpMode, 1); // position mode
        m_bus.advance(10);
    }
    EncoderSession &encoder() { return *m_bus.encoder(firstFraba); }
    // At most 5 s of bus time.
    void finish(const Job &job)
    {
        m_outcome.reset();
        ASSERT_TRUE(encoder().start(job));
        for (int i = 0; i < 500 && !m_outcome; ++i)
            m_bus.advance(10);
        ASSERT_TRUE(m_outcome);
    }

    const Catalog m_catalog = Catalog::builtIn();
    TrainingBus m_training = makeTrainingBus(m_catalog);
    RingSession m_bus{std::move(m_training.link), m_catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    std::optional<Outcome> m_outcome;
};

TEST_F(TrainingBusSession, Sets255StepsAndReadsThemBack)
{
    finish(WriteParameters{.values = {{Parameter::steps, 255},
                                      {Parameter::revolutions, 1},
                                      {Parameter::direction, 3},
                                      {Parameter::preset, 0}},
                           .onlyWhatDiffers = false,
                           .previous = {},
                           .initialisePreset = true});
    EXPECT_TRUE(m_outcome->result);
    EXPECT_EQ(encoder().latest().position, 0);
    EXPECT_EQ(encoder().eepromWrites(), m_outcome->eepromWrites);
    EXPECT_EQ(devicesWithOut(m_bus).size(), 0u);

    finish(ReadParameters{{Parameter::steps}});
    EXPECT_EQ(valueOf(m_outcome->read, Parameter::steps), 255);
    ASSERT_TRUE(encoder().known(Parameter::steps));
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 255);
    EXPECT_EQ(encoder().known(Parameter::steps)->evidence, Evidence::read);
}

// By the steps of before it would show neither the position of before nor the one that was set.
TEST_F(TrainingBusSession, WhatWasWrittenIsNotRestoredOnceThePositionWasSet)
{
    Progress progress;
    QObject::connect(&encoder(), &EncoderSession::progressed, &m_bus,
                     [&](const Progress &now) { progress = now; });
    ASSERT_TRUE(
        encoder().start(WriteParameters{.values = {{Parameter::steps, 500}, {Parameter::preset, 7}},
                                        .onlyWhatDiffers = false,
                                        .previous = {{Parameter::steps, 8192}, {Parameter::preset, 0}},
                                        .initialisePreset = true},
                        Pace::byHand));
    bool wasOffered = false;
    for (int i = 0; i < 500 && encoder().latest().position != 7; ++i) {
        m_bus.advance(10);
        wasOffered = wasOffered || (progress.hasTaken && progress.canRestore && !progress.setsPosition);
        encoder().proceed();
    }
    m_bus.advance(100);
    EXPECT_TRUE(wasOffered) << "before the position was set";
    EXPECT_TRUE(progress.setsPosition);
    EXPECT_FALSE(progress.canRestore);
    encoder().cancel(OnCancel::restorePrevious);
    m_bus.advance(5'000);
    ASSERT_TRUE(m_outcome);
    EXPECT_FALSE(m_outcome->result);
    EXPECT_TRUE(m_outcome->isPositionSet);
    EXPECT_FALSE(m_outcome->restored);
    EXPECT_EQ(valueOf(m_outcome->written, Parameter::steps), 500);
    EXPECT_EQ(encoder().latest().position, 7);
}

// Restoring costs no write for what is as it was.
TEST_F(TrainingBusSession, OnlyWhatDiffersIsRestored)
{
    Progress progress;
    QObject::connect(&encoder(), &EncoderSession::progressed, &m_bus,
                     [&](const Progress &now) { progress = now; });
    ASSERT_TRUE(
        encoder().start(WriteParameters{.values = {{Parameter::steps, 500}, {Parameter::preset, 0}},
                                        .onlyWhatDiffers = false,
                                        .previous = {{Parameter::steps, 8192}, {Parameter::preset, 0}}},
                        Pace::byHand));
    for (int i = 0; i < 500 && progress.confirmed.size() < 2; ++i) {
        m_bus.advance(10);
        encoder().proceed();
    }
    encoder().cancel(OnCancel::restorePrevious);
    m_bus.advance(5'000);
    ASSERT_TRUE(m_outcome);
    EXPECT_EQ(m_outcome->eepromWrites, 3);
    finish(ReadParameters{{Parameter::steps}});
    EXPECT_EQ(encoder().known(Parameter::steps)->value, 8192);
}

// Which encoder it is does not lie in its EEPROM.
TEST_F(TrainingBusSession, AnEncoderThatLosesItsParametersIsStillTheSame)
{
    finish(ReadParameters{{Parameter::steps, Parameter::serialNumber}});
    m_training.controls->setFault(TrainingFault::parametersLost, firstFraba.node, 1);
    m_bus.advance(10);
    EXPECT_FALSE(encoder().known(Parameter::steps));
    EXPECT_TRUE(encoder().known(Parameter::serialNumber));
}

TEST_F(TrainingBusSession, AnEncoderThatLosesItsParametersIsKnownNoMore)
{
    finish(ReadParameters{{Parameter::steps}});
    ASSERT_TRUE(encoder().known(Parameter::steps));
    m_training.controls->setFault(TrainingFault::parametersLost, firstFraba.node, 1);
    m_bus.advance(10);
    EXPECT_EQ(encoder().latest().state, EncoderState::error);
    EXPECT_FALSE(encoder().known(Parameter::steps));
}

// Between two answers of a read-out the encoder shows its error again: that is not another one.
TEST_F(TrainingBusSession, WhatIsReadInErrorIsKnown)
{
    m_training.controls->setFault(TrainingFault::parametersLost, firstFraba.node, 1);
    m_bus.advance(10);
    int errors = 0;
    const QObject listener;
    QObject::connect(&m_bus, &EncoderBus::messaged, &listener,
                     [&](const Message &message) { errors += message.id == MessageId::deviceFault ? 1 : 0; });
    finish(ReadParameters{{Parameter::serialNumber, Parameter::steps, Parameter::temperature}});
    EXPECT_EQ(encoder().latest().state, EncoderState::error);
    EXPECT_TRUE(encoder().known(Parameter::temperature));
    EXPECT_TRUE(encoder().known(Parameter::serialNumber));
    EXPECT_EQ(errors, 0);
}

TEST_F(TrainingBusSession, AlarmStopInTheMiddleOfAHandshakeZeroesOut)
{
    ASSERT_TRUE(encoder().start(WriteParameters{{{Parameter::steps, 255}}, false, {}, false}));
    m_bus.advance(3);
    ASSERT_EQ(devicesWithOut(m_bus), std::vector<Place>{firstFraba});
    m_bus.alarmStop();
    m_bus.advance(1);
    EXPECT_TRUE(devicesWithOut(m_bus).empty());
    ASSERT_TRUE(m_outcome);
    EXPECT_EQ(m_outcome->result.error().id, RefusalId::alarmStop);
}

// The bus stands then, and nobody sees the word leave OUT.
TEST_F(TrainingBusSession, WhatIsConfirmedAtAnAlarmStopIsCountedAtOnce)
{
    m_bus.channel(firstFraba)->stage(0x0200'0400);
    ASSERT_TRUE(m_bus.channel(firstFraba)->write());
    m_bus.advance(100);
    ASSERT_EQ(encoder().eepromWrites(), 0) << "it is still in OUT";
    m_bus.alarmStop();
    m_bus.advance(10);
    ASSERT_FALSE(m_bus.isRunning());
    EXPECT_EQ(encoder().eepromWrites(), 1);
    m_bus.setRunning(true);
    m_bus.advance(100);
    EXPECT_EQ(encoder().eepromWrites(), 1);
}

TEST_F(TrainingBusSession, WhatIsShownIsOldOnceTheBusStops)
{
    std::vector<Freshness::Reason> told;
    QObject::connect(&encoder(), &EncoderSession::freshnessChanged, &m_bus,
                     [&] { told.push_back(encoder().freshness().reason()); });
    EXPECT_TRUE(encoder().freshness().isLive());
    EXPECT_TRUE(m_bus.channel(firstFraba)->freshness().isLive());
    const Instant last = m_bus.now();
    m_bus.alarmStop();
    m_bus.advance(2000);
    EXPECT_TRUE(encoder().freshness().isOld());
    EXPECT_TRUE(m_bus.channel(firstFraba)->freshness().isOld());
    EXPECT_EQ(encoder().freshness().seen(), last);
    m_bus.setRunning(true);
    m_bus.advance(10);
    EXPECT_TRUE(encoder().freshness().isLive());
    m_bus.close();
    EXPECT_TRUE(encoder().freshness().isOld());
    EXPECT_EQ(told, (std::vector{Freshness::Reason::stopped, Freshness::Reason::none,
                                 Freshness::Reason::stopped, Freshness::Reason::disconnected}));
}

TEST_F(TrainingBusSession, WhatIsBehindASwitchedOffSegmentIsOld)
{
    const Place behind = m_bus.places().back();
    m_bus.switchSegment(DeviceNumber::of(behind.node).segment, false);
    m_bus.advance(10);
    EXPECT_EQ(m_bus.channel(behind)->freshness().reason(), Freshness::Reason::notOnBus);
    EXPECT_TRUE(encoder().freshness().isLive());
}

// It was pressed, and the lid was closed before the next cycle.
TEST_F(TrainingBusSession, AnAlarmStopFromBeforeTheSleepZeroesOut)
{
    bool hasSlept = false;
    QObject::connect(&m_bus, &RingSession::messaged, &m_bus, [&](const Message &message) {
        hasSlept = hasSlept || message.id == MessageId::computerSlept;
    });
    m_bus.channel(firstFraba)->stage(0x0200'00FF);
    ASSERT_TRUE(m_bus.channel(firstFraba)->write());
    m_bus.advance(3);
    ASSERT_EQ(devicesWithOut(m_bus), std::vector<Place>{firstFraba});
    m_bus.alarmStop();
    m_bus.startThread(std::chrono::milliseconds(1), oneSleepOf(std::chrono::hours(2)));
    while (!hasSlept || m_bus.isOperating())
        m_bus.pump();
    EXPECT_EQ(m_bus.latest().state, MasterState::ready);
    EXPECT_TRUE(devicesWithOut(m_bus).empty());
}

// The lid is closed during a handshake.
TEST_F(TrainingBusSession, AfterTheComputerSleptNothingMoreIsSent)
{
    std::vector<Message> messages;
    QObject::connect(&m_bus, &RingSession::messaged, &m_bus,
                     [&](const Message &message) { messages.push_back(message); });
    const auto said = [&](MessageCode id) {
        return std::ranges::find(messages, id, &Message::id) != messages.end();
    };
    ASSERT_TRUE(encoder().start(WriteParameters{{{Parameter::steps, 255}}, false, {}, false}));
    m_bus.advance(3);
    ASSERT_NE(m_bus.channel(firstFraba)->out(), 0U);
    const QDateTime before = m_bus.dateTime(m_bus.now());
    m_bus.startThread(std::chrono::milliseconds(1), oneSleepOf(std::chrono::hours(2)));
    while (!said(MessageId::computerSlept) || m_bus.isOperating())
        m_bus.pump();
    ASSERT_TRUE(m_outcome);
    EXPECT_EQ(m_outcome->result.error().id, RefusalId::computerSlept);
    EXPECT_FALSE(m_bus.isOperating());
    EXPECT_TRUE(m_bus.isRunning());
    EXPECT_GE(before.secsTo(m_bus.dateTime(m_bus.now())), 7200);
    const auto told = std::ranges::find(messages, MessageId::computerSlept, &Message::id);
    EXPECT_EQ(told->arguments, (std::vector<RefusalArgument>{std::int64_t{7200}}));
    EXPECT_EQ(encoder().start(SendWords{{0x020000FF}}).error().id, RefusalId::watchOnly);
    while (!encoder().freshness().isLive())
        m_bus.pump();
}

} // namespace
} // namespace codewheel
