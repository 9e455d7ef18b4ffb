// SPDX-License-Identifier: GPL-3.0-or-later
// At a real port, beside a master that is not heard while the finder listens.
#include "tests/cli/cli_run.h"
#include "tests/support/pty_pair.h"

#include <QJsonArray>

#include <array>
#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;

// Polls its only encoder.
class MasterOnLine
{
public:
    struct Habit
    {
        milliseconds first{}; // poll, after it has begun, or was woken
        milliseconds every{};
        bool wakes = false; // when it hears somebody else; otherwise it begins at once
    };

    explicit MasterOnLine(Habit habit)
        : m_habit(habit)
    {}

    QString port() const { return m_pty.path(); }
    bool wasAsked() const { return m_wasAsked; } // by others, before its first poll
    int polls() const { return m_polls; }        // that others have not let stop them
    int heardSince() const { return m_since; }   // bytes of others, since the newest of these

private:
    using Clock = std::chrono::steady_clock;

    void work(const std::stop_token &stop)
    {
        auto poll = Clock::now() + m_habit.first;
        bool isAwake = !m_habit.wakes;
        int polls = 0;
        while (!stop.stop_requested()) {
            const int heard = listen();
            if (heard > 0)
                note(heard, polls);
            if (!isAwake && heard > 0)
                poll = Clock::now() + m_habit.first;
            isAwake = isAwake || heard > 0;
            if (!isAwake || Clock::now() < poll)
                continue;
            ++polls;
            m_since = 0;
            m_pty.send("\x1B"
                       "05P\r\n");
            std::this_thread::sleep_for(5ms);
            m_pty.send("\r\n00001235\r\n");
            poll = Clock::now() + m_habit.every;
        }
    }
    void note(int heard, int polls)
    {
        m_wasAsked = m_wasAsked || polls == 0;
        m_polls = polls;
        m_since += heard;
    }
    int listen()
    {
        pollfd far{m_pty.descriptor(), POLLIN, 0};
        std::array<char, 256> bytes{};
        return ::poll(&far, 1, 5) == 1
                   ? static_cast<int>(::read(m_pty.descriptor(), bytes.data(), bytes.size()))
                   : 0;
    }

    const Habit m_habit;
    PtyPair m_pty;
    std::atomic<bool> m_wasAsked = false;
    std::atomic<int> m_polls = 0;
    std::atomic<int> m_since = 0;
    std::jthread m_thread{[this](const std::stop_token &stop) { work(stop); }};
};

void expectStops(const MasterOnLine &master)
{
    constexpr int request = 8; // bytes, with either protocol
    const CliRun run = runLine(QStringLiteral("find --yes --json ") + master.port());
    const QJsonObject json = run.json();
    for (const QJsonValue found : json[u"found"].toArray())
        EXPECT_TRUE(found[u"masterAtWork"].toBool()) << run.out;
    EXPECT_TRUE(json[u"news"].toArray().last()[u"text"].toString().startsWith(
        u"A master began to send while we asked: stopped."))
        << run.out;
    EXPECT_TRUE(master.wasAsked());
    // One poll may come while the port is opened with other settings.
    EXPECT_LE(master.polls(), 2);
    EXPECT_LE(master.polls() == 0 ? 0 : master.heardSince(), request) << "that crossed the poll";
}

TEST(FindBesideMaster, StopsWhenAMasterPollsThatPollsSeldom)
{
    expectStops(MasterOnLine({.first = 300ms, .every = 5'000ms, .wakes = true}));
}

TEST(FindBesideMaster, StopsWhenAMasterWakes)
{
    expectStops(MasterOnLine({.every = 300ms, .wakes = true}));
}

TEST(FindBesideMaster, StopsWhenAMasterBeginsLate)
{
    expectStops(MasterOnLine({.first = 9'000ms, .every = 300ms}));
}

} // namespace
} // namespace codewheel
