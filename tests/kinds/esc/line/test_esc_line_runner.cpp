// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const QByteArray askThree = "\x1B"
                            "03P\r\n";
const QByteArray askFive = "\x1B"
                           "05P\r\n";

class EscLineRunnerTest : public testing::Test
{
protected:
    EscLineRunnerTest()
    {
        EXPECT_TRUE(link.open({}));
        link.answers = {{askThree, "\r\n00000300\r\n"}, {askFive, "\r\n00001235\r\n"}};
    }

    void add(std::uint8_t address, Instant period = 10ms)
    {
        runner.post(line_command::AddDevice{std::make_unique<PollingDriver>(EscLineAddress{address}, period),
                                            QStringLiteral("encoder")});
    }
    void poll() { runner.post(line_command::SetRunning{true}); }
    void run(Instant duration) { runner.turn(link.now() + duration); }
    std::vector<Message> messages()
    {
        std::vector<Message> found;
        for (const EscLineEvent &event : runner.takeEvents())
            if (const auto *message = std::get_if<Message>(&event.what))
                found.push_back(*message);
        return found;
    }
    template <typename What>
    std::vector<What> taken()
    {
        std::vector<What> found;
        for (const EscLineEvent &event : runner.takeEvents())
            if (const auto *what = std::get_if<What>(&event.what))
                found.push_back(*what);
        return found;
    }

    ScriptedLink link;
    EscLineRunner runner{link, {}, {}};
};

TEST_F(EscLineRunnerTest, SendsNothingBeforeItIsToldToPoll)
{
    add(5);
    run(1s);
    EXPECT_TRUE(link.sent.empty());
}

TEST_F(EscLineRunnerTest, PollsEncodersInTurn)
{
    add(3);
    add(5);
    poll();
    run(200ms);
    const auto texts = link.sentTexts();
    ASSERT_GE(texts.size(), 10U);
    for (std::size_t i = 0; i + 1 < texts.size(); ++i)
        EXPECT_NE(texts[i], texts[i + 1]) << i;
    const auto latest = runner.takeLatest();
    ASSERT_TRUE(latest);
    ASSERT_EQ(latest->devices.size(), 2U);
    EXPECT_EQ(latest->devices[0].reading.position, 0x300);
    EXPECT_EQ(latest->devices[1].reading.position, 0x1235);
    EXPECT_EQ(latest->figures.requests, latest->figures.answers);
}

TEST_F(EscLineRunnerTest, KeepsTheAnswersOfTheOthersWhileOneIsSilent)
{
    link.answers.erase(askThree);
    add(3, 1s);
    add(5);
    poll();
    run(5s);
    const auto latest = runner.takeLatest();
    EXPECT_EQ(latest->devices[0].reading.state, EncoderState::silent);
    EXPECT_EQ(latest->devices[1].reading.state, EncoderState::operation);
    EXPECT_GT(latest->devices[1].figures.answers, 300U);
    EXPECT_EQ(latest->devices[0].figures.answers, 0U);
    EXPECT_EQ(latest->devices[0].figures.retries, 2U) << "of the first request, then it is silent";
    EXPECT_GE(latest->devices[0].figures.unanswered, 2U);
}

TEST_F(EscLineRunnerTest, AfterATimeOutWaitsForTwiceTheLongestAnswerSeen)
{
    link.delay = 70ms;
    add(5, 1s);
    poll();
    run(500ms);
    link.answers.clear();
    link.sent.clear();
    run(2s);
    ASSERT_GE(link.sent.size(), 2U);
    const Instant timeOut = 100ms;
    const Instant longest = runner.takeLatest()->figures.answerTime->longest;
    EXPECT_GT(longest, 60ms);
    EXPECT_GE(link.sent[1].at - link.sent[0].at, timeOut + 2 * longest);
}

TEST_F(EscLineRunnerTest, InWatchOnlyReadsAreSent)
{
    add(5);
    poll();
    run(50ms);
    messages();
    runner.post(line_command::StartJob{
        0, 1, WriteParameters{.values = {{Parameter::direction, 1}}, .previous = {}}, Pace::byItself});
    runner.post(line_command::Send{{.to = {5}, .command = esc::Command::writePreset, .data = 1}});
    run(50ms);
    std::vector<RefusalCode> refused;
    for (const EscLineEvent &event : runner.takeEvents()) {
        if (const auto *message = std::get_if<Message>(&event.what); message && message->refusal)
            refused.push_back(message->refusal->id);
        const auto *what = std::get_if<Event>(&event.what);
        if (const auto *outcome = what ? std::get_if<Outcome>(what) : nullptr)
            refused.push_back(outcome->result.error().id);
    }
    EXPECT_EQ(refused, (std::vector<RefusalCode>{RefusalId::watchOnly, RefusalId::watchOnly}));
    EXPECT_THAT(link.sentTexts(), testing::AllOf(testing::Not(testing::IsEmpty()), testing::Each("05P")));
}

TEST_F(EscLineRunnerTest, SendsWhatWasTypedOnceAndFirst)
{
    add(5);
    poll();
    run(50ms);
    const std::size_t before = link.sent.size();
    runner.post(line_command::Send{{.to = {0x12}, .command = esc::Command::version}});
    run(500ms);
    const auto texts = link.sentTexts();
    EXPECT_EQ(std::count(texts.begin(), texts.end(), QByteArray("12V")), 1);
    EXPECT_LE(std::find(texts.begin(), texts.end(), QByteArray("12V")) - texts.begin(),
              static_cast<std::ptrdiff_t>(before + 1));
    const auto answered = taken<TypedAnswered>();
    ASSERT_EQ(answered.size(), 1U);
    EXPECT_FALSE(answered.front().result.answer);
}

TEST_F(EscLineRunnerTest, WhatIsTypedGoesAtTheRateOfItsEncoder)
{
    auto driver = std::make_unique<PollingDriver>(EscLineAddress{5}, 1h);
    driver->speakAt(9'600);
    runner.post(line_command::AddDevice{std::move(driver), QStringLiteral("encoder")});
    for (const std::uint8_t address : {std::uint8_t{5}, std::uint8_t{0}, std::uint8_t{6}})
        runner.post(line_command::Send{{.to = {address}, .command = esc::Command::version}});
    run(2s);
    ASSERT_EQ(link.sent.size(), 3U);
    EXPECT_EQ(link.sent[0].baudRate, 9'600);
    EXPECT_EQ(link.sent[1].baudRate, 19'200) << "the master address: that of the line";
    EXPECT_EQ(link.sent[2].baudRate, 19'200) << "nobody knows it";
}

TEST_F(EscLineRunnerTest, FindsAnEncoderAtAnotherRateAndGoesBackToItsOwn)
{
    link.answersAt = 9'600;
    link.answers = {{"\x1B"
                     "05N\r\n",
                     "\r\n00123456\r\n"}};
    add(3);
    poll();
    runner.post(line_command::Scan{{.baudRates = {19'200, 9'600}}});
    run(60s);
    const auto ended = taken<ScanEnded>();
    ASSERT_EQ(ended.size(), 1U);
    ASSERT_EQ(ended.front().found.size(), 1U);
    EXPECT_EQ(ended.front().found.front().address, EscLineAddress{5});
    EXPECT_EQ(ended.front().found.front().baudRate, 9'600);
    EXPECT_FALSE(ended.front().cancelled);
    EXPECT_EQ(link.sent.back().baudRate, 19'200);
    EXPECT_EQ(link.sentTexts().back(), "03P");
}

TEST_F(EscLineRunnerTest, ASearchCanBeCancelled)
{
    runner.post(line_command::Scan{{}});
    run(500ms);
    runner.post(line_command::CancelScan{});
    run(100ms);
    const auto sent = link.sent.size();
    run(1s);
    EXPECT_EQ(link.sent.size(), sent);
    const auto ended = taken<ScanEnded>();
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_TRUE(ended.front().cancelled);
}

TEST_F(EscLineRunnerTest, TellsOnceThatThePortIsGoneAndOpensItAgain)
{
    add(5);
    poll();
    runner.post(line_command::SetOperate{true});
    run(50ms);
    runner.post(line_command::StartJob{0, 1, WriteParameters{}, Pace::byItself});
    run(10ms);
    runner.takeEvents();

    link.unplugged = true;
    run(10ms);
    std::vector<MessageCode> told;
    std::vector<Refusal> why;
    for (const EscLineEvent &event : runner.takeEvents()) {
        const auto *message = std::get_if<Message>(&event.what);
        if (message)
            told.push_back(message->id);
        const auto *what = std::get_if<Event>(&event.what);
        if (const auto *outcome = what ? std::get_if<Outcome>(what) : nullptr)
            why.push_back(outcome->result.error());
    }
    EXPECT_EQ(told, (std::vector<MessageCode>{EscMessageId::portLost}));
    const Refusal lost{RefusalKind::link, RefusalId::portLost, {QStringLiteral("scripted line")}};
    EXPECT_EQ(why, (std::vector{lost})); // about the job
    EXPECT_FALSE(runner.takeLatest()->connected);

    run(10ms);
    EXPECT_TRUE(messages().empty()); // it was reported already

    link.unplugged = false;
    link.letPass(1s);
    run(100ms);
    const auto back = messages();
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back.front().id, EscMessageId::portBack);
    EXPECT_EQ(link.opened, 2);
    EXPECT_EQ(link.sentTexts().back(), "05P");
    EXPECT_TRUE(runner.takeLatest()->connected);
}

TEST_F(EscLineRunnerTest, LooksForThePortOnceASecond)
{
    add(5);
    poll();
    run(50ms);
    link.unplugged = true;
    run(10s);
    EXPECT_EQ(link.now(), 10s + 50ms);
    EXPECT_NEAR(link.tries, 11, 1); // plus the first one
    EXPECT_EQ(messages().size(), 2U) << "polling began, and the port is gone";
}

TEST_F(EscLineRunnerTest, AnotherAdapterIsNotUsedUnasked)
{
    add(5);
    poll();
    run(50ms);
    link.unplugged = true;
    run(10ms);
    messages();
    link.unplugged = false;
    link.isOther = true;
    run(10s);
    const auto told = messages();
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told.front().refusal->id, RefusalId::portOfOther);
    auto latest = runner.takeLatest();
    EXPECT_TRUE(latest->otherAdapter);
    EXPECT_FALSE(latest->connected);
    EXPECT_EQ(latest->whyLost->id, RefusalId::portLost);
    EXPECT_EQ(link.opened, 1);

    runner.post(line_command::TakeOtherAdapter{});
    run(100ms);
    latest = runner.takeLatest();
    EXPECT_TRUE(latest->connected);
    EXPECT_FALSE(latest->whyLost);
    EXPECT_FALSE(latest->otherAdapter);
    EXPECT_EQ(messages().front().id, EscMessageId::portBack);
}

TEST_F(EscLineRunnerTest, WithoutLowLatencyAnAnswerMayComeLater)
{
    link.latency = LowLatency::refused;
    ASSERT_TRUE(runner.open({}));
    link.delay = 115ms; // including the request of 6 characters
    add(5, 1s);
    poll();
    run(5s);
    const auto told = messages();
    EXPECT_EQ(std::ranges::count(told, EscMessageId::lowLatencyRefused, &Message::id), 1);
    const auto latest = runner.takeLatest();
    EXPECT_EQ(latest->lowLatency, LowLatency::refused);
    EXPECT_EQ(latest->figures.timeOuts, 0U);
    EXPECT_GE(latest->figures.answers, 4U);
}

TEST_F(EscLineRunnerTest, WithLowLatencyItIsTooLate)
{
    link.delay = 115ms;
    add(5, 1s);
    poll();
    run(5s);
    EXPECT_GT(runner.takeLatest()->figures.timeOuts, 0U);
}

TEST_F(EscLineRunnerTest, EveryTypedRequestHasAnEnd)
{
    runner.post(line_command::Send{{.to = {5}, .command = esc::Command::writePreset, .data = 1}}); // in Watch
    runner.post(line_command::Send{{.to = {5}, .command = esc::Command::version}});
    runner.post(line_command::AlarmStop{});
    run(50ms);
    const auto ended = taken<TypedAnswered>();
    ASSERT_EQ(ended.size(), 2U);
    for (const TypedAnswered &one : ended)
        EXPECT_EQ(one.result.sent, 0);
    ASSERT_TRUE(ended[0].refused);
    EXPECT_EQ(ended[0].refused->id, RefusalId::watchOnly);
    EXPECT_FALSE(ended[1].refused) << "it was dropped";
}

TEST_F(EscLineRunnerTest, ATypedWriteCutOffByUnpluggingWasSent)
{
    runner.post(line_command::SetOperate{true});
    runner.post(line_command::Send{{.to = {5}, .command = esc::Command::writePreset, .data = 1}});
    run(2ms);
    link.unplugged = true;
    run(50ms);
    const auto ended = taken<TypedAnswered>();
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_EQ(ended.front().result.sent, 1);
    EXPECT_FALSE(ended.front().result.answer);
}

TEST_F(EscLineRunnerTest, CountsWhatComesWithoutHavingBeenAskedFor)
{
    link.answers = {{"\x1B"
                     "01P\r\n",
                     "\r\n00000001\r\n"}};
    add(1, 100ms);
    poll();
    run(50ms);
    const auto latest = runner.takeLatest();
    ASSERT_TRUE(latest);
    EXPECT_EQ(latest->figures.garbageBytes, 0U);
    EXPECT_EQ(latest->figures.answers, 1U);
}

TEST_F(EscLineRunnerTest, KeepsARowForEachThingThatPassed)
{
    add(5, 1s);
    poll();
    run(200ms);
    const auto rows = taken<esc::EscLineRow>();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].kind, esc::EscLineRow::Kind::sent);
    EXPECT_EQ(rows[0].bytes, askFive);
    EXPECT_EQ(rows[1].kind, esc::EscLineRow::Kind::answer);
    EXPECT_EQ(rows[1].bytes, QByteArray("\r\n00001235\r\n"));
    EXPECT_GT(rows[1].at, rows[0].at);
}

TEST_F(EscLineRunnerTest, AlarmStopEndsJobsAndDropsWhatWasTyped)
{
    add(5);
    poll();
    runner.post(line_command::SetOperate{true});
    run(50ms);
    runner.post(line_command::StartJob{0, 1, WriteParameters{}, Pace::byItself});
    runner.post(line_command::Send{{.to = {5}, .command = esc::Command::writePreset, .data = 1}});
    runner.post(line_command::AlarmStop{});
    run(100ms);
    EXPECT_THAT(link.sentTexts(), testing::AllOf(testing::Not(testing::IsEmpty()), testing::Each("05P")));
    EXPECT_FALSE(runner.takeLatest()->devices.front().hasJob);
}

// Nobody takes them: the first rows stay, later ones are counted, and no message is lost.
TEST_F(EscLineRunnerTest, KeepsTenThousandRowsAndCountsTheRest)
{
    add(5);
    poll();
    run(2min);
    runner.post(line_command::SetOperate{true});
    run(1s);
    const auto latest = runner.takeLatest();
    ASSERT_TRUE(latest);
    ASSERT_GT(latest->droppedRows, 0U);
    std::vector<esc::EscLineRow> rows;
    int messages = 0;
    int others = 0;
    for (const EscLineEvent &event : runner.takeEvents()) {
        if (const auto *row = std::get_if<esc::EscLineRow>(&event.what))
            rows.push_back(*row);
        else
            std::holds_alternative<Message>(event.what) ? ++messages : ++others;
    }
    EXPECT_EQ(messages, 2); // polling, and Operate
    EXPECT_GE(rows.size(), 9'990U);
    EXPECT_LE(rows.size(), 10'000U);
    EXPECT_EQ(rows.size() + latest->droppedRows, 2 * latest->figures.requests);
    EXPECT_LT(rows.front().at, 1s);
    EXPECT_LT(rows.back().at, 100s);
    run(1s);
    EXPECT_GT(taken<esc::EscLineRow>().size(), 100U) << "now there is room again";
    EXPECT_EQ(runner.takeLatest()->droppedRows, latest->droppedRows);
}

TEST_F(EscLineRunnerTest, TellsOfOperateAndOfWatchWhenTheyBegin)
{
    std::vector<MessageCode> told;
    for (const bool on : {false, true, true, false, false}) {
        runner.post(line_command::SetOperate{on});
        run(10ms);
        for (const Message &message : messages()) {
            EXPECT_FALSE(message.refusal);
            EXPECT_EQ(message.severity, Severity::information);
            told.push_back(message.id);
        }
        EXPECT_EQ(runner.takeLatest()->operate, on);
    }
    EXPECT_EQ(told, (std::vector<MessageCode>{MessageId::operateOn, MessageId::watchOn}));
}

} // namespace
} // namespace codewheel
