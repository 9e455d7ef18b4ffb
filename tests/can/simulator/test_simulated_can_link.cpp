// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/simulator/simulated_can_link.h"
#include "tests/can/can_link_contract.h"
#include "tests/can/simulator/scripted_participant.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using namespace test;

class SimulatedBench final : public CanBench
{
public:
    explicit SimulatedBench(SimulatedCanLink::Clock clock = {})
        : m_link(m_bus, 125'000, std::move(clock))
    {}
    CanLink &link() override { return m_link; }
    void peerSends(const CanFrame &frame) override
    {
        m_bus->locked([&] { m_peer->waiting.push_back(frame); });
    }
    std::vector<CanFrame> peerHeard() override
    {
        return m_bus->locked([&] {
            std::vector<CanFrame> frames;
            for (const auto &heard : std::exchange(m_peer->heard, {}))
                frames.push_back(heard.frame);
            return frames;
        });
    }
    void setPeerThere(bool there) override
    {
        m_bus->locked([&] { m_peer->on = m_witness->on = there; });
    }
    void makeBusOff() override { m_bus->forceBusOff(*m_link.adapter()); }
    void unplug() override { m_link.adapter()->setUnplugged(true); }

private:
    std::shared_ptr<SimulatedCanBus> m_bus = std::make_shared<SimulatedCanBus>();
    std::shared_ptr<ScriptedParticipant> m_peer = join(*m_bus);
    std::shared_ptr<ScriptedParticipant> m_witness = join(*m_bus); // acknowledges what is only watched
    SimulatedCanLink m_link;
};

Instant realTime()
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
}

INSTANTIATE_TEST_SUITE_P(
    Simulated, CanLinkContract,
    testing::Values(CanLinkUnderTest{"virtual time", [] { return std::make_unique<SimulatedBench>(); }},
                    CanLinkUnderTest{"real time",
                                     [] { return std::make_unique<SimulatedBench>(realTime); }}));

struct Linked
{
    std::shared_ptr<SimulatedCanBus> bus = std::make_shared<SimulatedCanBus>();
    std::shared_ptr<ScriptedParticipant> node = join(*bus);
    SimulatedCanLink link{bus};
};

TEST(SimulatedCanLink, WatchingAcknowledgesNothing)
{
    Linked bench;
    ASSERT_TRUE(bench.link.open(CanUse::watch));
    bench.node->waiting = {{.id = 0x705, .length = 1}};
    bench.link.wait(5ms);
    const CanNews watched = bench.link.receive(5ms).value();
    ASSERT_FALSE(watched.frames.empty());
    EXPECT_TRUE(watched.frames[0].isError);
    EXPECT_TRUE(bench.node->done.empty());
    EXPECT_EQ(bench.link.status().listensOnly, true);
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    bench.link.wait(20ms);
    EXPECT_EQ(bench.node->done.size(), 1U);
    EXPECT_EQ(bench.link.status().listensOnly, false);
}

TEST(SimulatedCanLink, AloneItSaysThatNobodyAcknowledges)
{
    Linked bench;
    bench.node->on = false;
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    ASSERT_TRUE(bench.link.send({.id = 0x000, .length = 2, .bytes = {0x81}}).value());
    const CanNews first = bench.link.receive(1s).value();
    ASSERT_EQ(first.frames.size(), 1U);
    EXPECT_TRUE(first.frames[0].isError);
    EXPECT_EQ(first.frames[0].id, 0xA0U); // linux/can/error.h: no acknowledge, bus error
    bench.link.wait(1s);
    EXPECT_TRUE(bench.link.receive(1s).value().fates.empty());
    EXPECT_EQ(bench.link.status(), (CanStatus{.state = CanState::passive,
                                              .transmitErrors = 128,
                                              .receiveErrors = 0,
                                              .rate = 125'000,
                                              .listensOnly = false}));
}

TEST(SimulatedCanLink, InBusOffAllThatWaitsIsRefused)
{
    Linked bench;
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    bench.bus->setFaults({.damaged = 1'000});
    for (std::uint32_t id = 1; id <= 3; ++id)
        ASSERT_TRUE(bench.link.send({.id = id}).value());
    bench.link.wait(1s);
    const CanNews news = bench.link.receive(1s).value();
    EXPECT_EQ(news.fates, std::vector(3, CanFate::refused));
    EXPECT_EQ(news.frames.back().id, 0x40U) << "bus off";
    EXPECT_TRUE(bench.node->heard.empty());
}

TEST(SimulatedCanLink, WhatNobodyFetchesIsCutOffAndSaidSo)
{
    Linked bench;
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    bench.node->waiting = {5'000, {.id = 0x080}};
    bench.link.wait(60s);
    const std::vector<CanFrame> frames = bench.link.receive(60s).value().frames;
    ASSERT_EQ(frames.size(), 4'097U);
    EXPECT_EQ(frames.back().id, 0x04U);
    EXPECT_EQ(frames.back().bytes[1], 0x01U) << "overrun of the receive buffer";
}

TEST(SimulatedCanLink, AFrameOfBeforeItWasClosedIsNotTakenForANewOne)
{
    Linked bench;
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    ASSERT_TRUE(bench.link.send({.id = 0x001}).value());
    bench.link.wait(100us); // on the wire
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    ASSERT_TRUE(bench.link.send({.id = 0x002}).value());
    bench.link.wait(10ms);
    EXPECT_EQ(bench.link.receive(10ms).value().fates, std::vector{CanFate::done});
    EXPECT_EQ(idsOf(bench.node->heard), (std::vector<std::uint32_t>{0x001, 0x002}));
}

TEST(SimulatedCanLink, InRealTimeItWaitsForWhatOthersDo)
{
    Linked bench;
    SimulatedCanLink link(bench.bus, 125'000, realTime);
    ASSERT_TRUE(link.open(CanUse::operate));
    const std::jthread other([&] {
        SimulatedCanLink another(bench.bus, 125'000, realTime);
        ASSERT_TRUE(another.open(CanUse::operate));
        EXPECT_TRUE(another.send({.id = 0x123}).value());
        EXPECT_EQ(another.receive(1h).value().fates, std::vector{CanFate::done});
    });
    CanNews news = link.receive(1h).value();
    ASSERT_EQ(news.frames.size(), 1U);
    EXPECT_EQ(news.frames[0].id, 0x123U);
}

TEST(SimulatedCanLink, TwoLinksShareTheBus)
{
    Linked bench;
    SimulatedCanLink other(bench.bus);
    ASSERT_TRUE(bench.link.open(CanUse::operate));
    ASSERT_TRUE(other.open(CanUse::operate));
    ASSERT_TRUE(bench.link.send({.id = 0x123}).value());
    EXPECT_EQ(other.receive(1s).value().frames.front().id, 0x123U);
    EXPECT_EQ(other.now(), bench.link.now());
    EXPECT_EQ(bench.link.receive(1s).value().fates, std::vector{CanFate::done});
}

} // namespace
} // namespace codewheel
