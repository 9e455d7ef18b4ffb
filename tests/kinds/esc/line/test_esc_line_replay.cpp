// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/esc/line/esc_line_replay.h"
#include "kinds/esc/line/esc_line_session.h"
#include "tests/kinds/esc/line/scripted_line.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Kind = esc::EscLineRow::Kind;
using Verdict = EscLineReplay::Verdict;

QByteArray wire(const char *text)
{
    return QByteArray("\x1B") + text + "\r\n";
}

// A poll sent twice, a typed position, a serial number without an answer, a preset.
EscLineRecord recordToReplay()
{
    EscLineRecord record;
    record.rows = {{{1ms, Kind::sent, wire("05P")}},          {{2ms, Kind::sent, wire("05P")}},
                   {{3ms, Kind::answer, "\r\n00001235\r\n"}}, {{4ms, Kind::sent, wire("05P")}, true},
                   {{5ms, Kind::garbage, "x"}, true},         {{6ms, Kind::answer, "\r\n00001236\r\n"}, true},
                   {{7ms, Kind::sent, wire("03N")}, true},    {{8ms, Kind::sent, wire("05GP00000001")}, true},
                   {{9ms, Kind::answer, "\r\n"}, true}};
    return record;
}

const ReplayStep poll{{{5}, esc::Command::position, 0}, "00001235"};
const ReplayStep typed{{{5}, esc::Command::position, 0}, "00001236"};
const ReplayStep silent{{{3}, esc::Command::serialNumber, 0}, {}};
const ReplayStep preset{{{5}, esc::Command::writePreset, 1}, QByteArray("")};

TEST(ReplaySteps, AreTheRequestsInTheirOrder)
{
    EXPECT_EQ(replaySteps(recordToReplay(), {.automatic = true, .writes = true}),
              (std::vector{poll, typed, silent, preset}));
}

TEST(ReplaySteps, LeaveOutPollsAndWritesUnlessAskedFor)
{
    EXPECT_EQ(replaySteps(recordToReplay(), {}), (std::vector{typed, silent}));
    EXPECT_EQ(replaySteps(recordToReplay(), {.writes = true}), (std::vector{typed, silent, preset}));
}

TEST(ReplaySteps, KeepTheBlanksOfAVersion)
{
    EscLineRecord record;
    record.rows = {{{1ms, Kind::sent, wire("05V")}, true}, {{2ms, Kind::answer, "\r\n V1 \r\n"}, true}};
    EXPECT_EQ(replaySteps(record, {}).front().answer, QByteArray(" V1 "));
}

class EscLineReplayTest : public testing::Test
{
protected:
    EscLineReplayTest()
    {
        auto made = std::make_unique<ScriptedLink>();
        link = made.get();
        link->answers = {{wire("05P"), "\r\n00001235\r\n"}, {wire("05GP00000001"), "\r\n"}};
        line = std::make_unique<EscLineSession>(std::move(made), catalog, QDateTime(),
                                                [](const DeviceDescription &, EscLineAddress address) {
                                                    return std::make_unique<PollingDriver>(address, 10ms);
                                                });
        QObject::connect(&replay, &EscLineReplay::answered,
                         [this](int, Verdict verdict, const QByteArray &) { verdicts.push_back(verdict); });
        QObject::connect(&replay, &EscLineReplay::ended,
                         [this](EscLineReplay::End how) { ends.push_back(how); });
    }
    void open(EscLineSession::Start start)
    {
        ASSERT_TRUE(line->open({}, {}, start, EscLineSession::Drive::byHand));
    }

    void pass(std::chrono::milliseconds time)
    {
        for (auto passed = 0ms; passed < time; passed += 10ms)
            line->advance(10ms);
    }

    const Catalog catalog = Catalog::builtIn();
    ScriptedLink *link = nullptr;
    std::unique_ptr<EscLineSession> line;
    EscLineReplay replay;
    std::vector<Verdict> verdicts;
    std::vector<EscLineReplay::End> ends;
};

TEST_F(EscLineReplayTest, SendsOneAfterTheOtherAndCompares)
{
    open(EscLineSession::Start::operating);
    replay.start(*line, {poll, typed, silent, preset});
    pass(2s);
    EXPECT_EQ(link->sentTexts(), (std::vector<QByteArray>{"05P", "05P", "03N", "05GP00000001"}));
    EXPECT_EQ(verdicts, (std::vector{Verdict::same, Verdict::differs, Verdict::same, Verdict::same}));
    EXPECT_EQ(ends, std::vector{EscLineReplay::End::done});
}

TEST_F(EscLineReplayTest, SaysWhereNoAnswerCame)
{
    open(EscLineSession::Start::watching);
    link->answers.clear();
    replay.start(*line, {poll});
    pass(2s);
    EXPECT_EQ(verdicts, std::vector{Verdict::noAnswer});
}

TEST_F(EscLineReplayTest, InWatchItEndsBeforeAWrite)
{
    open(EscLineSession::Start::watching);
    replay.start(*line, {poll, preset, poll});
    pass(2s);
    EXPECT_EQ(link->sentTexts(), (std::vector<QByteArray>{"05P"}));
    EXPECT_EQ(ends, std::vector{EscLineReplay::End::watchOnly});
}

TEST_F(EscLineReplayTest, AfterAlarmStopNothingMoreIsSent)
{
    open(EscLineSession::Start::operating);
    replay.start(*line, {poll, preset});
    line->alarmStop();
    pass(2s);
    EXPECT_LE(link->sent.size(), 1U);
    EXPECT_EQ(ends, std::vector{EscLineReplay::End::cancelled});
    EXPECT_FALSE(replay.isRunning());
}

TEST_F(EscLineReplayTest, EndsWithThePort)
{
    open(EscLineSession::Start::watching);
    replay.start(*line, {silent, poll});
    line->advance(1ms);
    link->unplugged = true;
    pass(100ms);
    EXPECT_EQ(ends, std::vector{EscLineReplay::End::portGone});
}

} // namespace
} // namespace codewheel
