// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "tests/kinds/interbus/ring/word_by_word_driver.h"
#include "tests/support/places.h"
#include "tests/support/scripted_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A ring of encoders with a runner, driven by hand.
class RingRunnerTest : public testing::Test
{
protected:
    void makeRing(std::size_t devices, const std::vector<Word> &peerOut = {})
    {
        m_link = std::make_unique<ScriptedLink>(devices);
        if (!peerOut.empty())
            m_link->setPeerOut(peerOut);
        m_runner = std::make_unique<RingRunner>(*m_link);
        EXPECT_TRUE(m_runner->open({}));
        useRing(devices);
        cycle();
        m_runner->takeLatest();
        m_events.clear();
        m_now = {};
    }
    void useRing(std::size_t devices)
    {
        command::UseRing ring{ScriptedLink::ringOf(devices), m_link->peerOut(), {}};
        for (std::size_t i = 0; i < devices; ++i) {
            auto driver = std::make_unique<WordByWordDriver>();
            m_drivers.push_back(driver.get());
            ring.drivers.push_back({std::move(driver), {}});
        }
        m_runner->post(std::move(ring));
    }
    void startOperating()
    {
        m_runner->post(command::StartBus{});
        m_runner->post(command::SetOperate{true});
    }
    void cycle(int n = 1)
    {
        for (; n > 0; --n)
            m_runner->cycle(m_now += std::chrono::milliseconds(1));
        for (RingEvent &event : m_runner->takeEvents())
            m_events.push_back(std::move(event));
    }
    template <typename T>
    std::vector<T> taken() const
    {
        std::vector<T> found;
        for (const RingEvent &event : m_events) {
            if constexpr (std::is_same_v<T, Outcome>) {
                if (const auto *any = std::get_if<Event>(&event.what))
                    if (const auto *outcome = std::get_if<Outcome>(any))
                        found.push_back(*outcome);
            } else if (const auto *what = std::get_if<T>(&event.what)) {
                found.push_back(*what);
            }
        }
        return found;
    }
    std::vector<MessageCode> messages() const
    {
        std::vector<MessageCode> ids;
        for (const Message &message : taken<Message>())
            ids.push_back(message.id);
        return ids;
    }
    void startJob(std::size_t device, JobId id, std::vector<Word> words)
    {
        m_runner->post(command::StartJob{device, id, SendWords{std::move(words)}, Pace::byItself});
    }
    Snapshot::Device shown(std::size_t device) { return m_runner->takeLatest()->devices.at(device); }

    std::unique_ptr<ScriptedLink> m_link;
    std::unique_ptr<RingRunner> m_runner;
    std::vector<WordByWordDriver *> m_drivers;
    std::vector<RingEvent> m_events;
    Instant m_now{};
};

const Word firstWord = 0x020000FF;
const Word secondWord = 0x04000001;

Refusal refusalAt(RefusalCode id, const char *place)
{
    return {RefusalKind::busy, id, {QString::fromLatin1(place)}};
}

TEST_F(RingRunnerTest, NothingIsExchangedBeforeTheBusIsStarted)
{
    makeRing(1);
    cycle(3);
    EXPECT_EQ(m_link->exchanges(), 0);
    EXPECT_EQ(m_runner->takeLatest()->state, MasterState::active);
    EXPECT_THAT(messages(), IsEmpty());
}

TEST_F(RingRunnerTest, AWrittenWordGoesOutInTheSameCycle)
{
    makeRing(2);
    startOperating();
    m_runner->post(command::SetOut{1, firstWord});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, firstWord));
    EXPECT_THAT(messages(), ElementsAre(MessageId::busStarted, MessageId::operateOn, MessageId::wordWritten));
    const Message written = taken<Message>().back();
    EXPECT_EQ(written.place, (Place{.node = NodeId("2.0")}));
    EXPECT_EQ(written.arguments, std::vector<RefusalArgument>{firstWord});
    EXPECT_EQ(written.at, std::chrono::milliseconds(1));
}

TEST_F(RingRunnerTest, InWatchOutStaysAsItWasReadBack)
{
    makeRing(1, {secondWord});
    m_runner->post(command::StartBus{});
    m_runner->post(command::SetOut{0, firstWord});
    startJob(0, 7, {firstWord});
    cycle(3);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(secondWord));
    EXPECT_EQ(taken<Message>().back().refusal, refusalAt(RefusalId::watchOnly, "1.0"));
    ASSERT_EQ(taken<Outcome>().size(), 1u);
    EXPECT_EQ(taken<Outcome>()[0].job, 7u);
    EXPECT_EQ(taken<Outcome>()[0].result.error(), refusalAt(RefusalId::watchOnly, "1.0"));
}

TEST_F(RingRunnerTest, OutOfADriverGoesOutOneCycleLater)
{
    makeRing(1);
    startOperating();
    std::vector<Word> wire;
    startJob(0, 1, {firstWord, secondWord});
    for (int i = 0; i < 5; ++i) {
        cycle();
        wire.push_back(m_link->peerOut()[0]);
    }
    EXPECT_THAT(wire, ElementsAre(0u, firstWord, secondWord, 0u, 0u));
    ASSERT_EQ(taken<Outcome>().size(), 1u);
    EXPECT_TRUE(taken<Outcome>()[0].result);
}

TEST_F(RingRunnerTest, AJobHoldsItsWordAndNoOther)
{
    makeRing(2);
    startOperating();
    startJob(0, 1, {firstWord, firstWord, firstWord});
    cycle();
    EXPECT_TRUE(shown(0).heldByJob);
    m_runner->post(command::SetOut{0, secondWord});
    m_runner->post(command::SetOut{1, secondWord});
    startJob(0, 2, {secondWord});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(firstWord, secondWord));
    EXPECT_EQ(taken<Message>().at(2).refusal, refusalAt(RefusalId::wordHeldByJob, "1.0"));
    EXPECT_EQ(taken<Outcome>().at(0).result.error(), refusalAt(RefusalId::jobRunning, "1.0"));
}

TEST_F(RingRunnerTest, AJobTheDriverDoesNotTakeEndsWithItsReason)
{
    makeRing(1);
    startOperating();
    m_runner->post(command::StartJob{0, 5, SetPreset{}, Pace::byItself});
    cycle();
    ASSERT_EQ(taken<Outcome>().size(), 1u);
    EXPECT_EQ(taken<Outcome>()[0].result.error().id, RefusalId::writingNotSupported);
    EXPECT_FALSE(shown(0).heldByJob);
}

TEST_F(RingRunnerTest, SwitchingToWatchIsRefusedDuringAJob)
{
    makeRing(1);
    startOperating();
    startJob(0, 1, {firstWord, secondWord});
    m_runner->post(command::SetOperate{false});
    cycle();
    EXPECT_TRUE(m_runner->takeLatest()->operate);
    EXPECT_EQ(taken<Message>().back().refusal, refusalAt(RefusalId::jobRunning, "1.0"));
}

TEST_F(RingRunnerTest, AlarmStopZeroesTheWholeRingAndEndsAllJobs)
{
    makeRing(3);
    startOperating();
    m_runner->post(command::SetOut{2, secondWord});
    startJob(0, 1, {firstWord, firstWord, firstWord, firstWord});
    startJob(1, 2, {firstWord, firstWord, firstWord, firstWord});
    cycle(2);
    m_runner->post(command::AlarmStop{});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u, 0u));
    ASSERT_EQ(taken<Outcome>().size(), 2u);
    for (const Outcome &outcome : taken<Outcome>())
        EXPECT_EQ(outcome.result.error(), (Refusal{RefusalKind::stopped, RefusalId::alarmStop, {}}));
    cycle(3);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u, 0u, 0u));
    EXPECT_EQ(messages().back(), RingMessageId::alarmStop);
}

TEST_F(RingRunnerTest, AlarmStopWorksInWatch)
{
    makeRing(1, {secondWord});
    m_runner->post(command::StartBus{});
    cycle();
    m_runner->post(command::AlarmStop{});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u));
}

TEST_F(RingRunnerTest, ZerosOfAnAlarmStopGoOutBeforeAnythingPostedAfterIt)
{
    makeRing(1, {secondWord});
    startOperating();
    m_runner->post(command::AlarmStop{});
    m_runner->post(command::SetOut{0, firstWord});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u));
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(firstWord));
}

TEST_F(RingRunnerTest, AlarmStopWhileStoppedZeroesWhatGoesOutAtTheNextStart)
{
    makeRing(1, {secondWord});
    m_runner->post(command::AlarmStop{});
    cycle();
    EXPECT_EQ(shown(0).out, 0u);
    EXPECT_EQ(m_link->exchanges(), 0);
    m_runner->post(command::StartBus{});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(0u));
}

TEST_F(RingRunnerTest, StoppingTheBusEndsJobsAndKeepsTheWordsOnTheWire)
{
    makeRing(1);
    startOperating();
    startJob(0, 1, {firstWord, secondWord});
    cycle(2); // wordA is out, wordB would be next
    m_runner->post(command::StopBus{});
    cycle(2);
    EXPECT_EQ(m_link->exchanges(), 2);
    EXPECT_EQ(shown(0).out, firstWord);
    EXPECT_EQ(taken<Outcome>().at(0).result.error().id, RefusalId::busStopped);
    m_runner->post(command::SetOut{0, secondWord});
    cycle();
    EXPECT_EQ(taken<Message>().back().refusal, refusalAt(RefusalId::notRunning, "1.0"));
    m_runner->post(command::StartBus{});
    cycle();
    EXPECT_THAT(m_link->peerOut(), ElementsAre(firstWord));
}

TEST_F(RingRunnerTest, AFailingLinkIsToldOnceAndJobsEnd)
{
    makeRing(1);
    startOperating();
    startJob(0, 1, {firstWord, secondWord, secondWord});
    cycle(2);
    m_link->failAt(1);
    cycle(5);
    EXPECT_EQ(m_runner->takeLatest()->state, MasterState::busFail);
    EXPECT_EQ(m_link->exchanges(), 3);
    EXPECT_EQ(taken<Outcome>().at(0).result.error(),
              (Refusal{RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("cable pulled")}}));
    ASSERT_THAT(messages(), ElementsAre(MessageId::busStarted, MessageId::operateOn, MessageId::refused));
    EXPECT_EQ(taken<Message>().back().refusal->id, RefusalId::linkFailed);
    EXPECT_EQ(taken<Message>().back().severity, Severity::fault);

    m_runner->post(command::StartBus{});
    cycle();
    EXPECT_EQ(m_runner->takeLatest()->state, MasterState::run);
    EXPECT_THAT(m_link->peerOut(), ElementsAre(firstWord)) << "a word that never went out is not sent later";
}

TEST_F(RingRunnerTest, AWordThatDidNotGoOutIsNotReportedAsWritten)
{
    makeRing(1);
    startOperating();
    m_link->failAt(1);
    m_runner->post(command::SetOut{0, firstWord});
    cycle(2);
    EXPECT_THAT(messages(), ElementsAre(MessageId::busStarted, MessageId::operateOn, MessageId::refused));
    EXPECT_EQ(shown(0).out, 0u);
}

TEST_F(RingRunnerTest, AFaultOfASingleCycleIsToldWithItsEnd)
{
    makeRing(2);
    m_runner->post(command::StartBus{});
    m_link->answerWith([this](std::size_t device, Word) -> Word {
        return device == 1 && m_link->exchanges() == 2 ? 0x86000000 : 0;
    });
    cycle(4);
    ASSERT_THAT(messages(),
                ElementsAre(MessageId::busStarted, MessageId::deviceFault, MessageId::deviceFaultGone));
    const Message fault = taken<Message>()[1];
    EXPECT_EQ(fault.place, (Place{.node = NodeId("2.0")}));
    EXPECT_EQ(fault.severity, Severity::fault);
    EXPECT_EQ(fault.arguments, (std::vector<RefusalArgument>{std::int64_t{3}, Word{0x86000000}}));
}

TEST_F(RingRunnerTest, ATraceRowIsAChangeOfOutOrStatusNeverOfThePositionAlone)
{
    makeRing(1);
    startOperating();
    const std::vector<Word> in{0x1000, 0x1001, 0x1002, 0xC20000FF, 0xC2000100, 0x1003, 0x1004, 0x1005};
    m_link->answerWith(
        [&](std::size_t, Word) { return in[static_cast<std::size_t>(m_link->exchanges() - 1)]; });
    cycle(7);
    m_runner->post(command::SetOut{0, firstWord});
    cycle();
    std::vector<std::uint64_t> rows;
    for (const Exchange &row : taken<Exchange>())
        rows.push_back(row.cycle);
    EXPECT_THAT(rows, ElementsAre(1u, 4u, 5u, 6u, 8u));
    const Exchange last = taken<Exchange>().back();
    EXPECT_EQ(last,
              (Exchange{8, std::chrono::milliseconds(8), firstWord, 0x1005, Mode::position, std::nullopt}));
}

TEST_F(RingRunnerTest, ASnapshotCarriesTheEdgesOfAllCyclesSinceTheOneBefore)
{
    makeRing(1);
    startOperating();
    m_link->answerWith([this](std::size_t, Word) -> Word { return m_link->exchanges() == 3 ? 0x10 : 0x01; });
    cycle();
    EXPECT_EQ(shown(0).inEdges, 0u) << "the first cycle is no change";
    m_runner->post(command::SetOut{0, firstWord});
    cycle(4);
    const auto device = shown(0);
    EXPECT_EQ(device.in, 0x01u);
    EXPECT_EQ(device.inEdges, 0x11u);
    EXPECT_EQ(device.outEdges, firstWord);
    EXPECT_FALSE(m_runner->takeLatest());
    cycle();
    EXPECT_EQ(shown(0).inEdges, 0u);
}

TEST_F(RingRunnerTest, LateCyclesAreAFigureAndNoMessage)
{
    makeRing(1);
    for (std::uint64_t late = 1; late <= 3; ++late) {
        m_runner->setPacing(std::chrono::milliseconds(1), late);
        cycle();
    }
    EXPECT_THAT(messages(), IsEmpty());
    EXPECT_EQ(m_runner->takeLatest()->lateCycles, 3u);
}

TEST_F(RingRunnerTest, ADeviceWithoutADriverShowsAndSendsItsWords)
{
    ScriptedLink link(1);
    link.answerWith([](std::size_t, Word out) { return out; });
    RingRunner runner(link);
    ASSERT_TRUE(runner.open({}));
    command::UseRing ring{ScriptedLink::ringOf(1), {0}, {}};
    ring.drivers.emplace_back();
    runner.post(std::move(ring));
    runner.post(command::StartBus{});
    runner.post(command::SetOperate{true});
    runner.post(command::SetOut{0, firstWord});
    runner.cycle(Instant{1000});
    EXPECT_EQ(runner.takeLatest()->devices[0].in, firstWord);
}

TEST_F(RingRunnerTest, KnownValuesReachTheDriver)
{
    makeRing(2);
    const std::vector<Known> known{{Parameter::coding, 3, Evidence::told, {}}};
    m_runner->post(command::SetKnown{1, known});
    cycle();
    EXPECT_EQ(m_drivers[1]->known(), known);
    EXPECT_THAT(m_drivers[0]->known(), IsEmpty());
}

TEST_F(RingRunnerTest, ASnapshotThatNobodyTookInTimeTellsOfTheSleep)
{
    makeRing(1);
    startOperating();
    cycle();
    m_link->wait(m_now);
    m_runner->slept(std::chrono::hours(1));
    cycle();
    const auto latest = m_runner->takeLatest();
    EXPECT_EQ(latest->awakeSince, m_now - std::chrono::milliseconds(1));
    EXPECT_FALSE(latest->operate);
}

constexpr std::size_t mostRows = RingRunner::Mail::maximumRows;

TEST_F(RingRunnerTest, RowsNobodyTakesAreDroppedAndCountedMessagesAreNot)
{
    makeRing(1);
    startOperating();
    const int rows = static_cast<int>(mostRows);
    for (int i = 0; i < rows + 5; ++i) {
        m_runner->post(command::SetOut{0, static_cast<Word>(i % 2)});
        m_runner->cycle(m_now += std::chrono::milliseconds(1));
    }
    EXPECT_EQ(m_runner->takeLatest()->droppedRows, 5u);
    cycle();
    EXPECT_EQ(taken<Exchange>().size(), mostRows);
    EXPECT_EQ(taken<Message>().size(), static_cast<std::size_t>(rows) + 5 + 2);
}

} // namespace
} // namespace codewheel
