// SPDX-License-Identifier: GPL-3.0-or-later
// How an encoder that answers fares beside silent ones, in virtual time on a line with real timing.
#include "catalog/catalog.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class SilentEncoders : public testing::Test
{
protected:
    SilentEncoders()
    {
        EXPECT_TRUE(link.open({}));
        runner.post(line_command::SetRunning{true});
    }

    void add(EscLineAddress address)
    {
        runner.post(
            line_command::AddDevice{std::make_unique<EscDriver>(*catalog.find(u"kuebler-esc-rs485"), address),
                                    QStringLiteral("encoder")});
    }
    void addAbsent(int count) // 13h and above: nobody
    {
        for (int i = 0; i < count; ++i)
            add({m_absent++});
    }
    void run(Instant duration) { runner.turn(link.now() + duration); }
    void setSilent(EscLineAddress address, bool silent)
    {
        EXPECT_TRUE(line->withEncoder(
            address, [&](SimulatedEscEncoder &encoder) { encoder.condition().mute = silent; }));
    }
    std::shared_ptr<const EscLineSnapshot> latest()
    {
        if (auto newest = runner.takeLatest())
            m_latest = std::move(newest);
        return m_latest;
    }
    const EscLineSnapshot::Device &shown(std::size_t place) { return latest()->devices.at(place); }
    // Answers of the first encoder.
    std::uint64_t answersIn(Instant duration)
    {
        const auto before = shown(0).figures.answers;
        run(duration);
        return shown(0).figures.answers - before;
    }

    const Catalog catalog = Catalog::builtIn();
    const std::shared_ptr<SimulatedEscLine> line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink link{line};
    EscLineRunner runner{link, {}, {}};

private:
    std::uint8_t m_absent = 0x13;
    std::shared_ptr<const EscLineSnapshot> m_latest;
};

TEST_F(SilentEncoders, TheOthersKeepTheirRate)
{
    add({3});
    run(10s);
    const auto alone = answersIn(20s);
    ASSERT_GT(alone, 1'000U);
    for (const int silent : {2, 11}) {
        addAbsent(silent);
        run(60s);
        EXPECT_GE(answersIn(20s), alone * 94 / 100) << silent;
    }
    for (std::size_t i = 1; i < latest()->devices.size(); ++i)
        EXPECT_EQ(shown(i).reading.state, EncoderState::silent) << i;
}

TEST_F(SilentEncoders, WhileSomeFallSilentTheOthersHaveAQuarterOfTheLine)
{
    add({3});
    run(10s);
    const auto alone = answersIn(4s);
    ASSERT_GT(alone, 200U);
    add({5});
    add({0x12});
    run(10s);
    setSilent({5}, true);
    setSilent({0x12}, true);
    EXPECT_GE(answersIn(4s), alone * 24 / 100);
    EXPECT_EQ(shown(1).reading.state, EncoderState::silent);
    EXPECT_EQ(shown(2).reading.state, EncoderState::silent);
}

TEST_F(SilentEncoders, OneThatFallsSilentIsShownAsSuchWithinTwoSeconds)
{
    add({3});
    add({5});
    add({0x12});
    run(10s);
    setSilent({5}, true);
    run(2s);
    EXPECT_EQ(shown(1).reading.state, EncoderState::silent);
}

TEST_F(SilentEncoders, EachIsAskedInItsTurnAndFoundAgain)
{
    add({3});
    add({5});
    add({0x12});
    addAbsent(4);
    run(10s);
    setSilent({5}, true);
    setSilent({0x12}, true);
    run(30s);
    setSilent({0x12}, false);
    run(20s); // six silent ones, 3 s each
    EXPECT_EQ(shown(1).reading.state, EncoderState::silent);
    EXPECT_EQ(shown(2).reading.state, EncoderState::operation);
}

TEST_F(SilentEncoders, WhenNobodyAnswersEachIsAskedEverySecond)
{
    add({3});
    add({5});
    add({0x12});
    run(5s);
    line->setSilent(true);
    run(20s);
    const auto before = shown(2).figures.requests;
    run(10s);
    EXPECT_NEAR(static_cast<double>(shown(2).figures.requests - before), 10, 1);
    line->setSilent(false);
    run(1500ms);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(shown(i).reading.state, EncoderState::operation) << i;
}

// Two bytes in a hundred are damaged, so about every fourth request goes unanswered.
TEST_F(SilentEncoders, ADamagedLineMakesNobodySilent)
{
    add({3});
    add({5});
    line->setFaults({.corrupted = 20});
    for (int seconds = 0; seconds < 300; ++seconds) {
        run(1s);
        for (const EscLineEvent &event : runner.takeEvents())
            if (const auto *message = std::get_if<Message>(&event.what)) {
                ASSERT_NE(message->id, MessageId::encoderSilent) << seconds;
            }
    }
    const EscLineFigures &figures = latest()->figures;
    EXPECT_GT(figures.timeOuts, figures.requests / 8);
    EXPECT_GT(figures.garbageBytes, 0U);
    for (const std::size_t i : {0U, 1U})
        EXPECT_GT(shown(i).figures.answers, 1'000U) << i;
}

TEST_F(SilentEncoders, APositionIsOldSoonerTheMoreOftenItComes)
{
    add({3});
    add({5});
    run(10s);
    EXPECT_EQ(shown(0).lateAfter, 1s);
    EXPECT_TRUE(shown(0).answers);
    line->setSilent(true);
    run(3s);
    EXPECT_FALSE(shown(0).answers);
    EXPECT_FALSE(shown(1).answers);
}

// Positions that come every two seconds are not old in between.
TEST_F(SilentEncoders, APositionThatSeldomComesIsNotOldInBetween)
{
    runner.post(line_command::AddDevice{std::make_unique<EscDriver>(*catalog.find(u"kuebler-esc-rs485"),
                                                                    EscLineAddress{3},
                                                                    EscSettings{.positionInterval = 1500ms}),
                                        QStringLiteral("encoder")});
    run(10s);
    EXPECT_GE(shown(0).lateAfter, 4500ms);
    EXPECT_LE(shown(0).lateAfter, Freshness::lateAfter);
}

TEST_F(SilentEncoders, WhileNoneAnswersTheirAgeIsTold)
{
    add({3});
    add({5});
    add({0x12});
    addAbsent(1);
    run(30s);
    line->setSilent(true);
    const Instant dead = link.now();
    const auto isOld = [this](std::size_t device) {
        const EscLineSnapshot &now = *latest();
        return now.at - now.devices.at(device).reading.at > now.devices.at(device).lateAfter;
    };
    while (!(isOld(0) && isOld(1) && isOld(2)) && link.now() < dead + 10s)
        run(10ms);
    EXPECT_LT(link.now() - dead, 1500ms);
}

TEST_F(SilentEncoders, AJobIsNotPutOff)
{
    add({3});
    addAbsent(1);
    run(30s);
    runner.takeEvents();
    const Instant begun = link.now();
    runner.post(line_command::StartJob{1, 7, ReadParameters{{Parameter::steps}}, Pace::byItself});
    std::optional<Instant> ended;
    std::optional<Outcome> outcome;
    while (!ended && link.now() < begun + 10s) {
        run(10ms);
        for (const EscLineEvent &event : runner.takeEvents())
            if (const auto *told = std::get_if<Event>(&event.what); told && event.device == 1)
                if (const auto *of = std::get_if<Outcome>(told)) {
                    ended = event.at;
                    outcome = *of;
                }
    }
    ASSERT_TRUE(ended);
    EXPECT_EQ(outcome->result.error().id, RefusalId::escNoAnswer);
    EXPECT_EQ(outcome->result.error().arguments.back(), RefusalArgument(std::int64_t{3})) << "tries";
    EXPECT_LT(*ended - begun, 1s);
}

} // namespace
} // namespace codewheel
