// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/wall_time.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/sleep_watch.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Reason = Freshness::Reason;

constexpr Freshness::Circumstances running{.isConnected = true, .isRunning = true, .now = 10s};

Reading shown(EncoderState state, Instant at)
{
    const bool neverWas = at == Instant{};
    return {.at = at,
            .state = state,
            .position = neverWas ? std::nullopt : std::optional<std::int64_t>(255),
            .mode = {},
            .coding = {},
            .errorNumber = {}};
}

struct FreshnessCase
{
    const char *what;
    EncoderState state;
    Instant at;
    Freshness::Circumstances bus;
    Freshness::State expected;
    Reason reason;
};

constexpr std::array freshnessCases{
    FreshnessCase{"comes now", EncoderState::operation, 10s, running, Freshness::State::live, Reason::none},
    FreshnessCase{"in its turn", EncoderState::operation, 5s, running, Freshness::State::live, Reason::none},
    FreshnessCase{"not asked for long", EncoderState::operation, 5s - 1us, running, Freshness::State::old,
                  Reason::notAsked},
    FreshnessCase{"asked every few ms, and late",
                  EncoderState::operation,
                  9s - 1us,
                  {.isConnected = true, .isRunning = true, .now = 10s, .lateAfter = 1s},
                  Freshness::State::old,
                  Reason::notAsked},
    FreshnessCase{"asked, and no answer for as long",
                  EncoderState::operation,
                  9s - 1us,
                  {.isConnected = true, .isRunning = true, .now = 10s, .lateAfter = 1s, .isAnswering = false},
                  Freshness::State::old,
                  Reason::silent},
    FreshnessCase{"one answer is missing",
                  EncoderState::operation,
                  9s,
                  {.isConnected = true, .isRunning = true, .now = 10s, .lateAfter = 1s, .isAnswering = false},
                  Freshness::State::live,
                  Reason::none},
    FreshnessCase{"only watched",
                  EncoderState::operation,
                  4s,
                  {.isConnected = true, .isRunning = true, .now = 10s, .whyNotAsked = Reason::watched},
                  Freshness::State::old,
                  Reason::watched},
    FreshnessCase{"stopped, and no answer",
                  EncoderState::operation,
                  4s,
                  {.isConnected = true,
                   .isRunning = true,
                   .now = 10s,
                   .isAnswering = false,
                   .whyNotAsked = Reason::nodeStopped},
                  Freshness::State::old,
                  Reason::nodeStopped},
    FreshnessCase{"only watched, and nothing came yet",
                  EncoderState::notSeen,
                  0s,
                  {.isConnected = true, .isRunning = true, .now = 10s, .whyNotAsked = Reason::watched},
                  Freshness::State::unknown,
                  Reason::notSeen},
    FreshnessCase{"an error is how it stands", EncoderState::error, 10s, running, Freshness::State::live,
                  Reason::none},
    FreshnessCase{"silent", EncoderState::silent, 10s, running, Freshness::State::old, Reason::silent},
    FreshnessCase{"silent for long", EncoderState::silent, 1s, running, Freshness::State::old,
                  Reason::silent},
    FreshnessCase{"silent from the beginning", EncoderState::silent, Instant{}, running,
                  Freshness::State::unknown, Reason::silent},
    FreshnessCase{"nothing came yet",
                  EncoderState::notSeen,
                  0s,
                  {.isConnected = true, .now = 10s},
                  Freshness::State::unknown,
                  Reason::notSeen},
    FreshnessCase{"its line was lost",
                  EncoderState::notSeen,
                  8s,
                  {.isConnected = true, .isLinkThere = false, .now = 10s},
                  Freshness::State::old,
                  Reason::linkLost},
    FreshnessCase{"its line is back, and nothing came since", EncoderState::notSeen, 8s, running,
                  Freshness::State::old, Reason::notSeen},
    FreshnessCase{"stopped",
                  EncoderState::operation,
                  10s,
                  {.isConnected = true, .now = 10s},
                  Freshness::State::old,
                  Reason::stopped},
    FreshnessCase{"stopped, and it was silent",
                  EncoderState::silent,
                  10s,
                  {.isConnected = true, .now = 10s},
                  Freshness::State::old,
                  Reason::stopped},
    FreshnessCase{
        "disconnected", EncoderState::operation, 10s, {}, Freshness::State::old, Reason::disconnected},
    FreshnessCase{"the port is gone",
                  EncoderState::operation,
                  10s,
                  {.isConnected = true, .isLinkThere = false, .isRunning = true, .now = 10s},
                  Freshness::State::old,
                  Reason::linkLost},
    FreshnessCase{"its segment is off",
                  EncoderState::operation,
                  10s,
                  {.isConnected = true, .isRunning = true, .isOnBus = false, .now = 10s},
                  Freshness::State::old,
                  Reason::notOnBus},
    FreshnessCase{"from before the computer slept",
                  EncoderState::operation,
                  9s,
                  {.isConnected = true, .isRunning = true, .awakeSince = 10s, .now = 10s},
                  Freshness::State::old,
                  Reason::slept},
    FreshnessCase{"the first since the computer slept",
                  EncoderState::operation,
                  10s,
                  {.isConnected = true, .isRunning = true, .awakeSince = 10s, .now = 10s},
                  Freshness::State::live,
                  Reason::none},
};

TEST(Freshness, OfAReadingAndHowTheBusStands)
{
    for (const FreshnessCase &one : freshnessCases) {
        const Freshness freshness(shown(one.state, one.at), one.bus);
        EXPECT_EQ(freshness.state(), one.expected) << one.what;
        EXPECT_EQ(freshness.reason(), one.reason) << one.what;
        if (freshness.state() != Freshness::State::unknown) {
            EXPECT_EQ(freshness.seen(), one.at) << one.what;
        }
    }
}

TEST(Freshness, ASentenceForEachReason)
{
    EXPECT_TRUE(freshnessText(Reason::none).isEmpty());
    QSet<QString> sentences;
    for (int reason = static_cast<int>(Reason::notSeen); reason <= static_cast<int>(Reason::slept); ++reason)
        sentences.insert(freshnessText(static_cast<Reason>(reason)));
    EXPECT_EQ(sentences.size(), static_cast<int>(Reason::slept));
    EXPECT_FALSE(sentences.contains(QString()));
}

TEST(Freshness, HowLongAgo)
{
    const QDateTime then(QDate(2026, 11, 23), QTime(2, 0), Qt::UTC);
    EXPECT_EQ(agoText(then, then), QStringLiteral("0 s ago"));
    EXPECT_EQ(agoText(then, then.addSecs(-5)), QStringLiteral("0 s ago"));
    EXPECT_EQ(agoText(then, then.addSecs(59)), QStringLiteral("59 s ago"));
    EXPECT_EQ(agoText(then, then.addSecs(60)), QStringLiteral("1 min ago"));
    EXPECT_EQ(agoText(then, then.addSecs(3599)), QStringLiteral("59 min ago"));
    EXPECT_EQ(agoText(then, then.addSecs(2 * 3600 + 5 * 60)), QStringLiteral("2 h 5 min ago"));
    EXPECT_EQ(agoText(then, then.addDays(1)), QLocale().toString(then.toLocalTime(), QLocale::ShortFormat));
}

TEST(SleepWatch, TellsEachSleepOnce)
{
    std::chrono::milliseconds slept{1000}; // before the program started
    SleepWatch watch([&slept] { return slept; });
    EXPECT_EQ(watch.sleptSinceLast(), 0ms);
    slept += 2h;
    EXPECT_EQ(watch.sleptSinceLast(), 2h);
    EXPECT_EQ(watch.sleptSinceLast(), 0ms);
}

// Reading two clocks takes time.
TEST(SleepWatch, TwoClocksThatDifferALittleAreNoSleep)
{
    std::chrono::milliseconds slept{0};
    SleepWatch watch([&slept] { return slept; });
    slept = 1ms;
    EXPECT_EQ(watch.sleptSinceLast(), 0ms);
    slept = -1ms;
    EXPECT_EQ(watch.sleptSinceLast(), 0ms);
}

TEST(SleepWatch, ThisComputerHasNotSleptBackwards)
{
    EXPECT_GE(SleepWatch::ofThisComputer(), 0ms);
}

TEST(WallTime, GoesOnWhileTheComputerSleeps)
{
    const QDateTime begin(QDate(2026, 11, 23), QTime(2, 0), Qt::UTC);
    WallTime time(begin);
    time.slept(1h, 10s);
    time.slept(2h, 20s);
    EXPECT_EQ(time.dateTime(9s), begin.addSecs(9));
    EXPECT_EQ(time.dateTime(10s), begin.addSecs(3600 + 10));
    EXPECT_EQ(time.dateTime(21s), begin.addSecs(3 * 3600 + 21));
}

TEST(WallTime, IsThatOfTheDayWhenABusIsOpenedAgain)
{
    const QDateTime begin(QDate(2026, 11, 23), QTime(2, 0), Qt::UTC);
    WallTime time(begin);
    time.goOn(begin.addSecs(71), 0s);
    EXPECT_EQ(time.dateTime(1s), begin.addSecs(72));
    time.goOn(begin.addSecs(600), 10s);
    EXPECT_EQ(time.dateTime(9s), begin.addSecs(80));
    EXPECT_EQ(time.dateTime(11s), begin.addSecs(601));
    time.goOn(begin, 12s);
    EXPECT_EQ(time.dateTime(12s), begin.addSecs(602)) << "it does not go back";
}

TEST(WallTime, LeadsBackToItsInstants)
{
    const QDateTime begin(QDate(2026, 11, 23), QTime(2, 0), Qt::UTC);
    WallTime time(begin);
    time.slept(1h, 10s);
    time.slept(2h, 20s);
    for (const Instant at :
         {Instant(-3600s), Instant(0s), Instant(9s), Instant(10s), Instant(19s), Instant(20s), Instant(25s)})
        EXPECT_EQ(time.instantOf(time.dateTime(at)), at) << at.count();
    EXPECT_EQ(time.instantOf(begin.addSecs(1'800)), Instant(10s)) << "within a sleep: its end";
}

} // namespace
} // namespace codewheel
