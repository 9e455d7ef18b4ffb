// SPDX-License-Identifier: GPL-3.0-or-later
// What comes while a line is asked: answers, or somebody else.
#include "finder/port_finder.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = FinderNews::Kind;
using namespace std::chrono_literals;

const QByteArray pollAndAnswer = "\x1B"
                                 "05P\r\n\r\n00001235\r\n";
const QByteArray unit2Asked = QByteArray::fromHex("02040000000131f9");
const QByteArray unit2Answer = QByteArray::fromHex("0204021234f047");

QByteArray request(const char *text)
{
    return QByteArray("\x1B") + text + "\r\n";
}

class AskingTest : public testing::Test
{
protected:
    // Nobody is on the line but an encoder at this address.
    void place(const QByteArray &address)
    {
        for (const QByteArray &its : {address, QByteArray("00")}) {
            link.answers[request(its + "N")] = "\r\n0012D503\r\n";
            link.answers[request(its + "B")] = "\r\n8000\r\n";
            link.answers[request(its + "V")] = "\r\n5882 FOR TESTS\r\n";
        }
    }
    // To its end, or until it has sent so much.
    void run(std::size_t requests = 10'000)
    {
        while (!finder.isDone() && link.sent.size() < requests)
            news.push_back(finder.next());
    }
    void runUntilSent(const QByteArray &bytes)
    {
        while (!finder.isDone() && (link.sent.empty() || link.sent.back().bytes != bytes))
            news.push_back(finder.next());
        ASSERT_FALSE(finder.isDone());
    }
    std::vector<Found> found() const
    {
        std::vector<Found> all;
        for (const FinderNews &one : news)
            if (one.found && !one.found->isMasterAtWork)
                all.push_back(*one.found);
        return all;
    }
    bool hasStopped() const
    {
        return news.back().sentence ==
               u"A master began to send while we asked: stopped. Nothing more is sent on this port.";
    }
    std::string lastSentence() const { return news.back().sentence.toStdString(); }

    ScriptedLink link;
    PortFinder finder{link, true};
    std::vector<FinderNews> news;
};

// Polls every 5 s, like some PLCs: 1.5 s of listening do not hear it. At whatever moment it comes.
TEST(AskingBesideAMaster, EndsWithItsFirstBytes)
{
    for (Instant at = 1'501ms; at < 17s; at += 137ms) {
        ScriptedLink link;
        link.talk = {at, pollAndAnswer, 5s};
        PortFinder finder(link, true);
        FinderNews last;
        while (!finder.isDone())
            last = finder.next();
        EXPECT_TRUE(last.sentence.startsWith(u"A master began to send while we asked"))
            << at.count() << ": " << last.sentence.toStdString();
        EXPECT_TRUE(std::ranges::none_of(link.sent, [&](const auto &sent) { return sent.at > at; }));
        ASSERT_TRUE(last.found) << "its bytes make sense";
        EXPECT_TRUE(last.found->isMasterAtWork);
    }
}

// On RS-422 only the answers of its encoders are heard.
TEST(AskingBesideAMaster, TakesNoAnswerToItsPollsForAnAnswer)
{
    for (const Instant every : {13ms, 70ms, 300ms, 1'000ms}) {
        ScriptedLink link;
        link.talk = {1'600ms, "\r\n00001235\r\n", every};
        PortFinder finder(link, true);
        while (!finder.isDone()) {
            const FinderNews news = finder.next();
            EXPECT_TRUE(!news.found || news.found->isMasterAtWork) << every.count();
        }
        EXPECT_LT(link.now(), 5s) << "it has stopped";
    }
}

TEST_F(AskingTest, WhatCameBeforeARequestIsNoAnswerToIt)
{
    run(1);
    link.talk = {link.now(), "\r\n0012D503\r\n"};
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_EQ(link.sent.size(), 1U);
}

TEST_F(AskingTest, AnAnswerThatComesTooLateIsOfSomebodyElse)
{
    place("03");
    link.delay = 140ms;
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_EQ(link.sent.size(), 1U);
}

TEST_F(AskingTest, AnAnswerToAnotherCommandIsOfSomebodyElse)
{
    place("03");
    link.answers[request("03V")] = "\r\n00001235\r\n"; // digits, where a text was asked for
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_TRUE(found().empty());
    EXPECT_EQ(link.sent.back().bytes, request("03V"));
}

TEST_F(AskingTest, MoreThanOneAnswerIsOfSomebodyElse)
{
    place("03");
    link.answers[request("03N")] = "\r\n0012D503\r\n\r\n0012D504\r\n";
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_TRUE(found().empty());
}

TEST_F(AskingTest, AFrameOfAnotherUnitIsOfSomebodyElse)
{
    link.answers[QByteArray::fromHex("01040000000131ca")] = unit2Answer;
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_TRUE(news.back().found) << "its bytes make sense";
}

TEST_F(AskingTest, AFindCountsIfTheLineIsQuietAfterIt)
{
    link.answers[unit2Asked] = unit2Answer;
    runUntilSent(unit2Asked);
    link.talk = {link.now() + 15ms, pollAndAnswer};
    run();
    EXPECT_TRUE(hasStopped()) << lastSentence();
    EXPECT_TRUE(found().empty());
}

TEST_F(AskingTest, AUnitIsThereOnceTwoAnswersAgree)
{
    link.answers[unit2Asked] = unit2Answer;
    runUntilSent(unit2Asked);
    link.answers.clear();
    run();
    EXPECT_TRUE(found().empty());
}

TEST_F(AskingTest, TheEchoOfARequestIsNoStranger)
{
    link.echoes = true;
    place("03");
    run();
    ASSERT_EQ(found().size(), 1U) << lastSentence();
    EXPECT_EQ(found()[0].kind, QStringLiteral("esc"));
}

TEST_F(AskingTest, TheEchoOfAModbusRequestIsNoStranger)
{
    link.echoes = true;
    link.answers[unit2Asked] = unit2Answer;
    run();
    ASSERT_EQ(found().size(), 1U) << lastSentence();
    EXPECT_EQ(found()[0].kind, QStringLiteral("interbus"));
}

TEST_F(AskingTest, AnswersThatABusyComputerReadsLateAreInTime)
{
    link.readsLate = 150ms;
    place("03");
    run();
    EXPECT_EQ(found().size(), 1U) << lastSentence();
}

// As when a converter changes its direction.
TEST_F(AskingTest, AByteOrTwoAroundAnAnswerAreNoStranger)
{
    place("03");
    for (auto &[its, answer] : link.answers)
        answer = QByteArray("\xFF") + answer + QByteArray("\0", 1);
    run();
    EXPECT_EQ(found().size(), 1U) << lastSentence();
}

TEST_F(AskingTest, SaysWhereBytesCameThatMakeNoSense)
{
    link.answersAt = 9'600;
    link.answers[QByteArray::fromHex("01040000000131ca")] = QByteArray::fromHex("01040200");
    run();
    EXPECT_TRUE(news.back().sentence.startsWith(
        u"Bytes came at 9600 Bd, 8E1; 9600 Bd, 8N1, but none that make sense."))
        << lastSentence();
    EXPECT_LT(link.now(), 18'600ms) << "after the first of them it listens again, not after each";
}

TEST_F(AskingTest, HalfAnAnswerMakesNoSense)
{
    link.answersAt = 9'600;
    link.answers[request("00N")] = "\r\n0012";
    run();
    EXPECT_TRUE(news.back().sentence.startsWith(u"Bytes came at 9600 Bd, 8N2, but none")) << lastSentence();
}

TEST_F(AskingTest, ListensAgainBeforeOtherSettings)
{
    run();
    for (std::size_t i = 1; i < link.sent.size(); ++i) {
        const bool isOther = link.sent[i].baudRate != link.sent[i - 1].baudRate;
        EXPECT_GE(link.sent[i].at - link.sent[i - 1].at, isOther ? 500ms : 100ms);
    }
    EXPECT_LT(link.now(), 18'200ms) << "a quarter more than without";
}

TEST_F(AskingTest, OneThatAnswersOnlyTheSecondTimeIsTold)
{
    place("05");
    link.answers[request("07N")] = "\xF0\xF1\xF2";
    runUntilSent(request("1FN"));
    place("03");
    run();
    ASSERT_EQ(found().size(), 2U);
    EXPECT_TRUE(found()[1].sentence.contains(u"address 03h")) << found()[1].sentence.toStdString();
}

TEST_F(AskingTest, ACancelledSearchSaysNothingAboutTheLine)
{
    finder.interrupt();
    run();
    EXPECT_EQ(news.back().sentence, u"The search was cancelled.");
    EXPECT_FALSE(finder.isSilent());
    EXPECT_TRUE(link.sent.empty());
}

} // namespace
} // namespace codewheel
