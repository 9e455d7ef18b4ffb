// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/kinds/interbus/ring/word_by_word_driver.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"

#include <QPointer>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Word wordA = 0x020000FF;
const Word wordB = 0x04000001;
const Place firstPlace = "1.0"_ring;
const Place secondPlace = "2.0"_ring;
const Place thirdPlace = "3.0"_ring;

RingStructure mixedRing()
{
    return {{firstPlace.node, 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")},
            {secondPlace.node, 0x0237, 2, 2, {}},
            {thirdPlace.node, 0x81BE, 1, 0, {}}};
}

// Two encoders, one of unknown make, and a digital input.
class BusSessionTest : public testing::Test
{
protected:
    BusSessionTest()
    {
        auto link = std::make_unique<ScriptedLink>(mixedRing());
        m_link = link.get();
        m_bus = std::make_unique<RingSession>(std::move(link), m_catalog,
                                              QDateTime(QDate(2026, 3, 1), QTime(14, 2), Qt::UTC), nullptr,
                                              [this](const DeviceDescription &) {
                                                  auto driver = std::make_unique<WordByWordDriver>();
                                                  m_drivers.push_back(driver.get());
                                                  return driver;
                                              });
        QObject::connect(m_bus.get(), &RingSession::messaged, m_bus.get(),
                         [this](const Message &message) { m_messages.push_back(message); });
    }
    void open(RingSession::Start start)
    {
        ASSERT_TRUE(m_bus->open(start));
        QObject::connect(encoder(), &EncoderSession::finished, m_bus.get(),
                         [this](const Outcome &outcome) { m_outcomes.push_back(outcome); });
        QObject::connect(channel(), &WordChannel::refused, m_bus.get(),
                         [this](const Refusal &why) { m_refused.push_back(why.id); });
    }
    EncoderSession *encoder() const { return m_bus->encoder(firstPlace); }
    WordChannel *channel() const { return m_bus->channel(firstPlace); }
    std::vector<MessageCode> messages() const
    {
        std::vector<MessageCode> ids;
        for (const Message &message : m_messages)
            ids.push_back(message.id);
        return ids;
    }

    const Catalog m_catalog = Catalog::builtIn();
    ScriptedLink *m_link = nullptr;
    std::vector<WordByWordDriver *> m_drivers;
    std::unique_ptr<RingSession> m_bus;
    std::vector<Message> m_messages;
    std::vector<Outcome> m_outcomes;
    std::vector<RefusalCode> m_refused;
};

TEST_F(BusSessionTest, OpeningShowsOutAsReadBackAndSendsNothing)
{
    m_link->setPeerOut({wordA, 0, 0});
    open(RingSession::Start::watching);
    EXPECT_TRUE(m_bus->isRunning());
    EXPECT_FALSE(m_bus->isOperating());
    EXPECT_EQ(m_link->exchanges(), 0);
    EXPECT_EQ(channel()->out(), wordA);
    EXPECT_THAT(devicesWithOut(*m_bus), ElementsAre(firstPlace));
    m_bus->advance(3);
    EXPECT_EQ(m_link->peerOut()[0], wordA);
    EXPECT_EQ(m_bus->latest().at, std::chrono::milliseconds(3));
    EXPECT_EQ(m_bus->dateTime(m_bus->latest().at), QDateTime(QDate(2026, 3, 1), QTime(14, 2, 0, 3), Qt::UTC));
}

// Its clock starts at 0 again, and nothing of the ring before is shown with the times of the new one.
TEST_F(BusSessionTest, AnotherLinkHasAnotherClockAndAnotherRing)
{
    const QDateTime later(QDate(2026, 3, 1), QTime(14, 10), Qt::UTC);
    open(RingSession::Start::watching);
    m_bus->advance(60'000);
    const auto before = m_bus->useLink(std::make_unique<ScriptedLink>(mixedRing()), later);
    EXPECT_EQ(before.get(), m_link);
    EXPECT_EQ(encoder(), nullptr);
    EXPECT_THAT(m_bus->places(), IsEmpty());
    EXPECT_EQ(m_bus->dateTime(m_bus->now()), later);
    open(RingSession::Start::watching);
    m_bus->advance(20);
    EXPECT_EQ(m_bus->dateTime(m_bus->now()), later.addMSecs(20));
    EXPECT_EQ(m_bus->dateTime(encoder()->freshness().seen()), later.addMSecs(20));
}

TEST_F(BusSessionTest, TimesNeverGoBackWithAnotherLink)
{
    open(RingSession::Start::watching);
    m_bus->advance(5'000);
    const QDateTime last = m_bus->dateTime(m_bus->now());
    m_bus->useLink(std::make_unique<ScriptedLink>(mixedRing()), last.addSecs(-60));
    EXPECT_EQ(m_bus->dateTime(m_bus->now()), last);
}

TEST_F(BusSessionTest, ALinkThatDoesNotOpenLeavesNothingRunning)
{
    m_link->lose();
    const auto opened = m_bus->open(RingSession::Start::watching);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().id, RefusalId::linkFailed);
    m_bus->advance(1);
    EXPECT_FALSE(m_bus->isRunning());
    EXPECT_THAT(m_bus->places(), IsEmpty());
}

TEST_F(BusSessionTest, EncodersAreDescribedByTheirKeyOrByTheirIdCode)
{
    open(RingSession::Start::watching);
    EXPECT_THAT(m_bus->places(), ElementsAre(firstPlace, secondPlace, thirdPlace));
    EXPECT_EQ(encoder()->device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_TRUE(m_bus->encoder(secondPlace)->device().isGeneric());
    EXPECT_EQ(m_bus->encoder(thirdPlace), nullptr);
    ASSERT_NE(m_bus->channel(thirdPlace), nullptr);
    EXPECT_EQ(m_bus->encoder("9.0"_ring), nullptr);
    EXPECT_EQ(m_bus->channel("9.0"_ring), nullptr);
}

TEST_F(BusSessionTest, AStagedWordStaysUntilItStandsOnTheBus)
{
    open(RingSession::Start::operating);
    channel()->stage(wordA);
    m_bus->advance(2);
    EXPECT_EQ(m_link->peerOut()[0], 0u);
    EXPECT_TRUE(channel()->write());
    EXPECT_EQ(channel()->shownOut(), wordA);
    m_bus->advance(1);
    EXPECT_EQ(m_link->peerOut()[0], wordA);
    EXPECT_EQ(channel()->out(), wordA);
    EXPECT_EQ(channel()->outEdges(), wordA);
    EXPECT_EQ(channel()->staged(), std::nullopt);
    EXPECT_EQ(messages().back(), MessageId::wordWritten);
}

TEST_F(BusSessionTest, AWordStagedWhileAnotherIsOnItsWayStays)
{
    open(RingSession::Start::operating);
    channel()->stage(wordA);
    EXPECT_TRUE(channel()->write());
    channel()->stage(wordB);
    m_bus->advance(1);
    EXPECT_EQ(channel()->out(), wordA);
    EXPECT_EQ(channel()->staged(), wordB);
}

TEST_F(BusSessionTest, WritingIsAnsweredAtOnce)
{
    open(RingSession::Start::watching);
    channel()->stage(wordA);
    EXPECT_EQ(channel()->write().error().id, RefusalId::watchOnly);
    m_bus->setOperate(true);
    m_bus->advance(1);
    ASSERT_TRUE(encoder()->start(SendWords{{wordB, wordB}}));
    EXPECT_EQ(channel()->write().error().id, RefusalId::wordHeldByJob) << "before a cycle shows it";
    m_bus->setRunning(false);
    m_bus->advance(1);
    EXPECT_EQ(channel()->write().error().id, RefusalId::notRunning);
    EXPECT_THAT(m_refused,
                ElementsAre(RefusalId::watchOnly, RefusalId::wordHeldByJob, RefusalId::notRunning));
    EXPECT_EQ(channel()->staged(), wordA);
    EXPECT_EQ(m_bus->channel(thirdPlace)->write().error().id, RefusalId::sendingNotSupported);
}

TEST_F(BusSessionTest, ALateRefusalComesAsASignalAndKeepsTheStagedWord)
{
    open(RingSession::Start::operating);
    m_bus->advance(1);
    m_bus->setOperate(false); // not carried out yet
    channel()->stage(wordA);
    EXPECT_TRUE(channel()->write());
    EXPECT_THAT(m_refused, IsEmpty());
    m_bus->advance(1);
    EXPECT_THAT(m_refused, ElementsAre(RefusalId::watchOnly));
    EXPECT_EQ(channel()->staged(), wordA);
    EXPECT_EQ(m_link->peerOut()[0], 0u);
}

TEST_F(BusSessionTest, AJobRunsAndItsEndIsReported)
{
    open(RingSession::Start::operating);
    std::vector<Exchange> rows;
    QObject::connect(encoder(), &EncoderSession::exchanged, m_bus.get(),
                     [&](const Exchange &row) { rows.push_back(row); });
    const auto job = encoder()->start(SendWords{{wordA, wordB}});
    ASSERT_TRUE(job);
    EXPECT_EQ(encoder()->runningJob(), *job);
    EXPECT_EQ(encoder()->start(SendWords{{wordA}}).error().id, RefusalId::jobRunning);
    m_bus->advance(10);
    EXPECT_EQ(encoder()->runningJob(), std::nullopt);
    ASSERT_EQ(m_outcomes.size(), 1u);
    EXPECT_EQ(m_outcomes[0].job, *job);
    std::vector<Word> out;
    out.reserve(rows.size());
    for (const Exchange &row : rows)
        out.push_back(row.out);
    EXPECT_THAT(out, ElementsAre(0u, wordA, wordB, 0u));
    EXPECT_EQ(m_messages.back().id, MessageId::wordsSent);
    EXPECT_EQ(m_messages.back().place, firstPlace);
    EXPECT_EQ(m_messages.back().at, std::chrono::milliseconds(3));
}

TEST_F(BusSessionTest, AJobIsRefusedAtOnceInWatch)
{
    open(RingSession::Start::watching);
    EXPECT_EQ(encoder()->start(SendWords{{wordA}}).error().id, RefusalId::watchOnly);
    EXPECT_EQ(encoder()->runningJob(), std::nullopt);
}

TEST_F(BusSessionTest, ANextJobCanBeStartedWhenOneHasFinished)
{
    open(RingSession::Start::operating);
    int started = 1;
    QObject::connect(encoder(), &EncoderSession::finished, m_bus.get(), [&] {
        if (started++ == 3)
            return;
        EXPECT_TRUE(encoder()->start(SendWords{{wordA}}));
    });
    ASSERT_TRUE(encoder()->start(SendWords{{wordA}}));
    for (int i = 0; i < 20; ++i)
        m_bus->advance(1);
    EXPECT_EQ(m_outcomes.size(), 3u);
}

TEST_F(BusSessionTest, AlarmStopEndsTheJobAndZeroesTheRing)
{
    open(RingSession::Start::operating);
    m_bus->channel(secondPlace)->stage(wordB);
    ASSERT_TRUE(m_bus->channel(secondPlace)->write());
    ASSERT_TRUE(encoder()->start(SendWords{{wordA, wordA, wordA, wordA}}));
    m_bus->advance(2);
    m_bus->alarmStop();
    m_bus->advance(1);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u, 0u));
    ASSERT_EQ(m_outcomes.size(), 1u);
    EXPECT_EQ(m_outcomes[0].result.error().id, RefusalId::alarmStop);
    EXPECT_THAT(devicesWithOut(*m_bus), IsEmpty());
}

TEST_F(BusSessionTest, OutOfOneDeviceCanBeZeroed)
{
    m_link->setPeerOut({wordA, wordB, 0});
    open(RingSession::Start::operating);
    EXPECT_TRUE(m_bus->channel(secondPlace)->zero());
    EXPECT_FALSE(m_bus->channel(thirdPlace)->zero()) << "it has no OUT";
    m_bus->advance(1);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(wordA, 0u, 0u));
    EXPECT_THAT(devicesWithOut(*m_bus), ElementsAre(firstPlace));
}

TEST_F(BusSessionTest, ClosingEndsJobsAndTellsSo)
{
    open(RingSession::Start::operating);
    int states = 0;
    QObject::connect(m_bus.get(), &RingSession::stateChanged, m_bus.get(), [&] { ++states; });
    ASSERT_TRUE(encoder()->start(SendWords{{wordA, wordA, wordA}}));
    m_bus->advance(1);
    m_bus->close();
    ASSERT_EQ(m_outcomes.size(), 1u);
    EXPECT_EQ(m_outcomes[0].result.error().id, RefusalId::busStopped);
    EXPECT_FALSE(m_link->isOpen());
    EXPECT_FALSE(m_bus->isRunning());
    EXPECT_GT(states, 0);
    EXPECT_EQ(encoder()->start(SendWords{{wordA}}).error().id, RefusalId::notRunning);
    m_bus->advance(5);
    EXPECT_EQ(m_link->exchanges(), 1);

    ASSERT_TRUE(m_bus->open(RingSession::Start::operating));
    m_bus->advance(1);
    EXPECT_EQ(m_link->exchanges(), 2);
}

TEST_F(BusSessionTest, ALostLinkIsTriedEachSecondAndOutIsReadBack)
{
    open(RingSession::Start::operating);
    m_bus->advance(1);
    EncoderSession *before = encoder();
    before->tell(Parameter::steps, 255);
    std::vector<Refusal> refused;
    QObject::connect(m_bus.get(), &RingSession::refused, m_bus.get(),
                     [&](const Refusal &why) { refused.push_back(why); });
    m_link->lose();
    m_bus->advance(3'500);
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_EQ(std::get<QString>(refused.front().arguments.front()), QStringLiteral("cable pulled"));
    EXPECT_EQ(m_bus->latest().whyLost,
              (Refusal{RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("no answer")}}))
        << "why the last try failed";
    EXPECT_EQ(m_link->tries(), 4);
    EXPECT_EQ(m_bus->state(), BusState::lost);
    m_link->comeBack();
    m_link->setPeerOut({0, wordB, 0}); // by another program
    m_messages.clear();
    m_bus->advance(1'000);
    EXPECT_THAT(messages(), ElementsAre(RingMessageId::linkBack, MessageId::busStarted));
    EXPECT_FALSE(m_bus->latest().whyLost);
    EXPECT_TRUE(m_bus->isRunning());
    EXPECT_FALSE(m_bus->isOperating());
    EXPECT_EQ(m_bus->channel(secondPlace)->out(), wordB);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, wordB, 0u));
    EXPECT_EQ(encoder(), before);
    EXPECT_FALSE(before->known(Parameter::steps)) << "another encoder may be there by now";
}

TEST_F(BusSessionTest, AnotherRingAfterALostLinkIsTakenOver)
{
    open(RingSession::Start::operating);
    m_bus->advance(1);
    int changes = 0;
    QObject::connect(m_bus.get(), &RingSession::structureChanged, m_bus.get(), [&] { ++changes; });
    const QPointer<EncoderSession> gone = encoder();
    const QPointer<EncoderSession> kept = m_bus->encoder(secondPlace);
    m_link->lose();
    m_bus->advance(10);
    RingStructure other = mixedRing();
    other.erase(other.begin());
    m_link->comeBackAs(other);
    m_bus->advance(1'000);
    m_bus->advance(10);
    EXPECT_EQ(changes, 1);
    EXPECT_THAT(m_bus->places(), ElementsAre(secondPlace, thirdPlace));
    EXPECT_EQ(gone, nullptr);
    EXPECT_EQ(m_bus->encoder(secondPlace), kept);
    EXPECT_TRUE(m_bus->isRunning());
    EXPECT_FALSE(m_bus->isOperating());
    EXPECT_TRUE(kept->freshness().isLive());
    m_bus->setOperate(true);
    m_bus->advance(1);
    EXPECT_TRUE(kept->start(SendWords{{wordA}}));
    m_bus->advance(2);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(wordA, 0u)) << "at its new place";
}

// The bus thread has already found the other ring when it is started with the previous one.
TEST_F(BusSessionTest, AJobForARingThatIsNoMoreEndsOnce)
{
    open(RingSession::Start::operating);
    m_bus->advance(1);
    RingStructure other = mixedRing();
    other.pop_back();
    m_link->comeBackAs(other); // the exchanged data does not match it: refused
    m_bus->startThread(std::chrono::microseconds(200));
    std::this_thread::sleep_for(std::chrono::milliseconds(1'300));
    ASSERT_TRUE(encoder()->start(SendWords{{wordA}}));
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (m_bus->places().size() == 3 && std::chrono::steady_clock::now() < end)
        m_bus->pump();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    m_bus->pump();
    ASSERT_EQ(m_outcomes.size(), 1u);
    EXPECT_EQ(m_outcomes[0].result.error().id, RefusalId::busStopped);
    EXPECT_EQ(m_bus->places().size(), 2u);
    m_bus->close();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u));
}

TEST_F(BusSessionTest, StopHoldsForALostLinkAndStartTriesAtOnce)
{
    open(RingSession::Start::operating);
    m_bus->advance(1);
    m_link->lose();
    m_bus->advance(10);
    m_bus->setRunning(false);
    m_link->comeBack();
    m_bus->advance(2'000);
    EXPECT_EQ(m_bus->state(), BusState::open);
    EXPECT_FALSE(m_bus->isRunning());
    m_bus->setRunning(true);
    m_bus->advance(1);
    EXPECT_TRUE(m_bus->isRunning());
    m_link->lose();
    m_bus->advance(10);
    m_link->comeBack();
    m_bus->setRunning(true);
    m_bus->advance(2);
    EXPECT_TRUE(m_bus->isRunning());
}

TEST_F(BusSessionTest, AnAlarmStopOnALostLinkIsCarriedOutOnceItIsBack)
{
    open(RingSession::Start::operating);
    m_bus->channel(secondPlace)->stage(wordB);
    ASSERT_TRUE(m_bus->channel(secondPlace)->write());
    m_bus->advance(1);
    m_link->lose();
    m_bus->advance(10);
    m_bus->alarmStop();
    m_bus->advance(10);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, wordB, 0u));
    m_link->comeBack();
    m_bus->advance(1'010);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u, 0u));
    EXPECT_FALSE(m_bus->isOperating());
}

TEST_F(BusSessionTest, ZerosOfAnAlarmStopGoOutBeforeItCloses)
{
    open(RingSession::Start::operating);
    m_bus->channel(secondPlace)->stage(wordB);
    ASSERT_TRUE(m_bus->channel(secondPlace)->write());
    m_bus->advance(1);
    m_bus->alarmStop();
    m_link->interrupt(); // for the next call, as left by a thread that ends
    m_bus->close();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u, 0u));
}

TEST_F(BusSessionTest, TimeIsThatOfTheLinksClock)
{
    open(RingSession::Start::watching);
    m_link->wait(std::chrono::seconds(5)); // expires by itself
    m_bus->advance(std::chrono::milliseconds(10));
    EXPECT_EQ(m_link->exchanges(), 10);
    EXPECT_EQ(m_bus->now(), std::chrono::milliseconds(5'010));
}

TEST_F(BusSessionTest, ClosingFromAHandlerTellsTheRest)
{
    open(RingSession::Start::operating);
    ASSERT_TRUE(encoder()->start(SendWords{{wordA, wordA, wordA}}));
    QObject::connect(m_bus.get(), &RingSession::updated, m_bus.get(), [this] { m_bus->close(); });
    m_bus->advance(1);
    m_bus->pump();
    ASSERT_EQ(m_outcomes.size(), 1u);
    EXPECT_EQ(messages().back(), MessageId::busStopped);
}

TEST_F(BusSessionTest, WhatIsToldIsKnownUntilItIsTakenBack)
{
    open(RingSession::Start::watching);
    EXPECT_EQ(encoder()->known(Parameter::steps), std::nullopt);
    encoder()->tell(Parameter::steps, 255);
    ASSERT_TRUE(encoder()->known(Parameter::steps));
    EXPECT_EQ(encoder()->known(Parameter::steps)->value, 255);
    EXPECT_EQ(encoder()->known(Parameter::steps)->evidence, Evidence::told);
    m_bus->advance(1);
    ASSERT_EQ(m_drivers[0]->known().size(), 1u);
    encoder()->tell(Parameter::steps, std::nullopt);
    m_bus->advance(1);
    EXPECT_EQ(encoder()->known(Parameter::steps), std::nullopt);
    EXPECT_THAT(m_drivers[0]->known(), IsEmpty());
}

TEST_F(BusSessionTest, WhatADriverLearnsReplacesAndRemovesWhatWasKnown)
{
    open(RingSession::Start::watching);
    encoder()->tell(Parameter::steps, 255);
    encoder()->tell(Parameter::preset, 7);
    const Known read{Parameter::steps, 8192, Evidence::read, std::chrono::milliseconds(1)};
    m_drivers[0]->learn({.known = {read}, .noLongerKnown = {Parameter::preset}, .eepromWrites = 2});
    int changes = 0;
    QObject::connect(encoder(), &EncoderSession::knownChanged, m_bus.get(), [&] { ++changes; });
    m_bus->advance(1);
    EXPECT_EQ(encoder()->known(Parameter::steps), read);
    EXPECT_EQ(encoder()->known(Parameter::preset), std::nullopt);
    EXPECT_EQ(encoder()->eepromWrites(), 2);
    EXPECT_EQ(changes, 1);
}

TEST_F(BusSessionTest, AnEncoderThatLostItsParametersIsKnownNoMore)
{
    open(RingSession::Start::watching);
    encoder()->tell(Parameter::steps, 255);
    m_link->answerWith([this](std::size_t device, Word) -> Word {
        return device == 0 && m_link->exchanges() == 2 ? 0x86000000 : 0;
    });
    m_bus->advance(4);
    EXPECT_EQ(encoder()->known(Parameter::steps), std::nullopt);
    EXPECT_THAT(messages(), ElementsAre(MessageId::busStarted, MessageId::deviceFault,
                                        MessageId::valuesForgotten, MessageId::deviceFaultGone));
    EXPECT_EQ(m_messages.at(1).refusal->id, RefusalId::parametersLost) << "named as the manual does";
    m_bus->advance(1);
    EXPECT_THAT(m_drivers[0]->known(), IsEmpty());
}

TEST_F(BusSessionTest, AFrameIsToldOnceHoweverManyCyclesItTook)
{
    open(RingSession::Start::watching);
    int updates = 0;
    int changes = 0;
    QObject::connect(m_bus.get(), &RingSession::updated, m_bus.get(), [&] { ++updates; });
    QObject::connect(channel(), &WordChannel::changed, m_bus.get(), [&] { ++changes; });
    m_link->answerWith([this](std::size_t, Word) { return static_cast<Word>(m_link->exchanges()); });
    m_bus->advance(3); // IN 1, 2, 3
    EXPECT_EQ(updates, 1);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(channel()->in(), 3u);
    EXPECT_EQ(channel()->inEdges(), 3u);
    EXPECT_EQ(encoder()->latest().in, 3u);
    m_bus->pump();
    EXPECT_EQ(updates, 1);
}

TEST_F(BusSessionTest, RunsByAThreadOfItsOwnAndEndsWithIt)
{
    for (int i = 0; i < 50; ++i) {
        m_outcomes.clear();
        open(RingSession::Start::operating);
        m_bus->startThread(std::chrono::microseconds(200));
        ASSERT_TRUE(encoder()->start(SendWords{{wordA}}));
        while (m_outcomes.empty()) {
            m_bus->pump();
            std::this_thread::yield();
        }
        EXPECT_TRUE(m_outcomes[0].result);
        m_bus->close();
    }
}

} // namespace
} // namespace codewheel
