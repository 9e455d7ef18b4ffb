// SPDX-License-Identifier: GPL-3.0-or-later
// A ring behind a gateway: what is sent and when, what somebody else sends, and what is said about it.
#include "bus/bus_outline.h"
#include "bus/word_channel.h"
#include "history/encoder_history.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "tests/support/faulty_register_port.h"
#include "tests/support/gateway_session.h"
#include "tests/support/passing_port.h"

#include <atomic>
#include <thread>

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr Place writtenPlace = "1.0"_ring;
constexpr Word ownWord = 0x0200'00FF;
constexpr Word foreignWord = 0x0400'0001;

class GatewayRing : public testing::Test
{
protected:
    void make(const GatewayMaking &making = {}) { ring = std::make_unique<GatewaySession>(making, around()); }
    void open(EncoderBus::Start start, const GatewayMaking &making = {})
    {
        make(making);
        ASSERT_TRUE(ring->bus->open(start));
        ring->bus->advance(200ms);
    }
    GatewaySession::MakePort around()
    {
        return [this](std::unique_ptr<RegisterPort> made) {
            auto faulty = std::make_unique<FaultyRegisterPort>(std::move(made), 1, watch);
            port = faulty.get();
            return faulty;
        };
    }
    void write(Word word)
    {
        ring->bus->channel(writtenPlace)->stage(word);
        ASSERT_TRUE(ring->bus->channel(writtenPlace)->write());
        ring->bus->advance(100ms);
    }
    void loseLink()
    {
        port->make({.closed = 1});
        ring->bus->advance(100ms);
        ASSERT_EQ(ring->bus->state(), BusState::lost);
    }
    void giveLinkBack()
    {
        port->make({});
        ring->bus->advance(8s);
        ASSERT_EQ(ring->bus->state(), BusState::open);
    }
    Word outThere() const { return ring->gateway->out().front(); }
    bool isTold(RefusalCode id) const
    {
        return std::ranges::any_of(ring->messages, [id](const Message &message) {
            return message.refusal && message.refusal->id == id;
        });
    }

    std::shared_ptr<FaultyRegisterPort::Watch> watch = std::make_shared<FaultyRegisterPort::Watch>();
    FaultyRegisterPort *port = nullptr;
    std::unique_ptr<GatewaySession> ring;
};

TEST_F(GatewayRing, ConnectingAndWatchingWriteNothing)
{
    open(EncoderBus::Start::watching);
    ring->bus->advance(5s);
    EXPECT_TRUE(ring->encoder(writtenPlace).freshness().isLive());
    EXPECT_EQ(ring->gateway->writes(), 0);
    ring->bus->setOperate(true);
    ring->bus->advance(100ms);
    EXPECT_GT(ring->gateway->writes(), 0);
    ring->bus->setOperate(false);
    ring->bus->advance(100ms);
    const int writes = ring->gateway->writes();
    ring->bus->advance(5s);
    EXPECT_EQ(ring->gateway->writes(), writes);
}

TEST_F(GatewayRing, DisconnectingFromItStopsNoBus)
{
    open(EncoderBus::Start::watching);
    ring->bus->close();
    EXPECT_EQ(std::ranges::count(ring->messages, MessageId::busStopped, &Message::id), 0);
}

TEST_F(GatewayRing, AnEditedWordIsSentOnceAJobHasSentIt)
{
    open(EncoderBus::Start::operating);
    WordChannel &words = *ring->bus->channel(writtenPlace);
    words.stage(0x2021'0001);
    ASSERT_TRUE(ring->encoder(writtenPlace).start(ReadParameters{{Parameter::steps}}));
    for (int i = 0; i < 5'000 && words.out() != 0x2021'0001; ++i)
        ring->bus->advance(1ms);
    ASSERT_EQ(words.out(), 0x2021'0001);
    EXPECT_EQ(words.staged(), std::nullopt);
    words.stage(0x0200'00FF);
    ring->bus->advance(1s);
    EXPECT_EQ(words.staged(), 0x0200'00FF) << "that nobody has sent";
}

TEST_F(GatewayRing, WhatIsThereStaysThereInOperateToo)
{
    make();
    ring->gateway->setOut(0, foreignWord);
    ASSERT_TRUE(ring->bus->open(EncoderBus::Start::operating));
    ring->bus->advance(1s);
    EXPECT_EQ(outThere(), foreignWord);
    EXPECT_EQ(ring->bus->channel(writtenPlace)->out(), foreignWord);
    EXPECT_TRUE(ring->bus->isOperating());
}

TEST_F(GatewayRing, SomebodyElsesWordIsNamedAndTheBusGivesWay)
{
    open(EncoderBus::Start::operating);
    std::optional<Outcome> outcome;
    QObject::connect(&ring->encoder(writtenPlace), &EncoderSession::finished, ring->bus.get(),
                     [&](const Outcome &ended) { outcome = ended; });
    ASSERT_TRUE(ring->encoder(writtenPlace)
                    .start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    for (int i = 0; i < 1'000 && outThere() == 0; ++i)
        ring->bus->advance(1ms);
    const Word own = outThere();
    ASSERT_NE(own, 0u);
    ring->bus->advance(4ms);
    ring->gateway->setOut(0, foreignWord);
    const Instant written = ring->bus->now();
    ring->bus->advance(50ms);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(whyOf(*outcome), "outsOfOther");
    EXPECT_FALSE(ring->bus->isOperating());
    const auto told = std::ranges::find_if(ring->messages, [](const Message &message) {
        return message.refusal && message.refusal->id == GatewayRefusalId::outNotOurs;
    });
    ASSERT_NE(told, ring->messages.end());
    EXPECT_EQ(told->refusal->arguments,
              (std::vector<RefusalArgument>{QStringLiteral("1.0"), own, foreignWord}));
    EXPECT_GE(told->at, written - 10ms);
    EXPECT_EQ(outThere(), foreignWord) << "it is not overwritten";
    ring->bus->advance(1s);
    EXPECT_EQ(outThere(), foreignWord);
    EXPECT_EQ(ring->bus->channel(writtenPlace)->out(), foreignWord);
}

// Operate is asked for in the same moment as the foreign word is found.
TEST_F(GatewayRing, OperateAgainDoesNotOverwriteWhatWasNotSeenYet)
{
    open(EncoderBus::Start::operating);
    write(ownWord);
    ring->gateway->setOut(0, foreignWord);
    for (int i = 0; i < 50 && ring->bus->isOperating(); ++i)
        ring->bus->advance(1ms);
    ring->bus->setOperate(true);
    ring->bus->advance(100ms);
    EXPECT_EQ(outThere(), foreignWord);
}

TEST_F(GatewayRing, APlcThatWritesAgainAndAgainIsNoticedEachTime)
{
    open(EncoderBus::Start::operating);
    write(ownWord);
    for (int i = 0; i < 5; ++i) {
        ring->messages.clear();
        ring->bus->setOperate(true);
        for (int k = 0; k < 20; ++k) {
            ring->gateway->setOut(0, foreignWord + static_cast<Word>(k));
            ring->bus->advance(10ms);
        }
        EXPECT_TRUE(isTold(GatewayRefusalId::outNotOurs)) << i;
        EXPECT_FALSE(ring->bus->isOperating());
    }
    EXPECT_EQ(outThere(), foreignWord + 19);
}

TEST_F(GatewayRing, AlarmStopWritesZerosInWatchAndWhileStopped)
{
    open(EncoderBus::Start::watching);
    for (const bool isRunning : {true, false}) {
        ring->gateway->setOut(0, foreignWord);
        ring->bus->setRunning(isRunning);
        ring->bus->advance(100ms);
        ring->messages.clear();
        ring->bus->alarmStop();
        ring->bus->advance(100ms);
        EXPECT_TRUE(ring->isOutZero()) << isRunning;
        EXPECT_EQ(ring->countOf(RingMessageId::zerosAsked), 1u);
        EXPECT_EQ(ring->countOf(RingMessageId::zerosReadBack), 1u);
        const int writes = ring->gateway->writes();
        ring->bus->advance(1s);
        EXPECT_EQ(ring->gateway->writes(), writes) << "once";
    }
}

TEST_F(GatewayRing, ZerosThatAreOverwrittenAreSaidToBe)
{
    open(EncoderBus::Start::watching);
    ring->gateway->written = [this] { ring->gateway->setOut(0, foreignWord); };
    ring->bus->alarmStop();
    ring->bus->advance(3s);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosOverwritten), 1u);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosReadBack), 0u);
}

TEST_F(GatewayRing, ZerosThatComeLateHaveArrived)
{
    open(EncoderBus::Start::watching, {.ways = {.lag = 700ms}});
    ring->gateway->setOut(0, foreignWord);
    ring->bus->advance(2s);
    ring->bus->alarmStop();
    ring->bus->advance(3s);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosOverwritten), 0u);
}

TEST_F(GatewayRing, AlarmStopDoesNotWaitForTheNextPoll)
{
    open(EncoderBus::Start::operating, {.settings = {.pollInterval = 10s}});
    ring->bus->advance(25s);
    ring->gateway->setOut(0, foreignWord);
    ring->bus->alarmStop();
    ring->bus->advance(30ms);
    EXPECT_TRUE(ring->isOutZero());
    ring->bus->setOperate(false);
    ring->bus->advance(30ms);
    EXPECT_FALSE(ring->bus->isOperating());
    ring->bus->setRunning(false);
    ring->bus->advance(30ms);
    EXPECT_FALSE(ring->bus->isRunning());
}

TEST_F(GatewayRing, TheZerosOfAnAlarmStopGoFirstOnceTheLinkIsBack)
{
    open(EncoderBus::Start::operating);
    write(ownWord);
    loseLink();
    ring->bus->alarmStop();
    ring->bus->advance(100ms);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosWait), 1u);
    EXPECT_EQ(ring->countOf(RingMessageId::zerosAsked), 0u) << "nothing was set to 0";
    EXPECT_EQ(outThere(), ownWord);
    giveLinkBack();
    EXPECT_TRUE(ring->isOutZero());
    EXPECT_EQ(ring->countOf(RingMessageId::zerosReadBack), 1u);
}

TEST_F(GatewayRing, ALostLinkMakesEveryValueOldAndComesBackInWatch)
{
    open(EncoderBus::Start::operating);
    write(ownWord);
    loseLink();
    for (const Place place : ring->bus->places())
        EXPECT_EQ(ring->bus->channel(place)->freshness().reason(), Freshness::Reason::linkLost)
            << place.toString().toStdString();
    ring->gateway->setOut(0, foreignWord); // meanwhile
    const int writes = ring->gateway->writes();
    giveLinkBack();
    EXPECT_FALSE(ring->bus->isOperating());
    EXPECT_EQ(ring->gateway->writes(), writes);
    EXPECT_EQ(ring->bus->channel(writtenPlace)->out(), foreignWord);
    EXPECT_TRUE(ring->encoder(writtenPlace).freshness().isLive());
}

TEST_F(GatewayRing, ALostOrClosedLinkExchangesNothing)
{
    open(EncoderBus::Start::watching);
    ring->bus->advance(3s);
    EXPECT_GT(ring->bus->latest().figures->exchangesPerSecond, 0);
    const Instant lastSeen = ring->encoder(writtenPlace).freshness().seen();
    loseLink();
    ring->bus->advance(3s);
    EXPECT_EQ(ring->bus->latest().figures->exchangesPerSecond, 0);
    EXPECT_LE(ring->encoder(writtenPlace).freshness().seen() - lastSeen, 100ms);
    EXPECT_GE(ring->encoder(writtenPlace).freshness().seen(), lastSeen) << "of the last reception";
    giveLinkBack();
    ring->bus->advance(3s);
    EXPECT_GT(ring->bus->latest().figures->exchangesPerSecond, 0);
    ring->bus->close();
    EXPECT_EQ(ring->bus->latest().figures->exchangesPerSecond, 0);
}

TEST_F(GatewayRing, OutThatCannotBeReadBackIsNotKnownUntilItIsAskedFor)
{
    open(EncoderBus::Start::watching, {.settings = {.readsBack = false}});
    EXPECT_TRUE(isTold(GatewayRefusalId::outNotReadBack));
    ring->gateway->setOut(1, 0x4000'0001); // by a controller
    const auto known = [this] {
        std::vector<bool> each;
        for (const Snapshot::Device &device : ring->bus->latest().devices)
            each.push_back(device.outIsKnown);
        return each;
    };
    EXPECT_EQ(known(), std::vector<bool>(known().size(), false));
    ring->bus->setOperate(true);
    ring->bus->advance(2s);
    EXPECT_EQ(ring->gateway->writes(), 0) << "nobody has asked for anything";
    write(ownWord);
    EXPECT_EQ(outThere(), ownWord);
    EXPECT_EQ(std::ranges::count(known(), true), 1);
    EXPECT_EQ(ring->gateway->out()[1], 0x4000'0001u) << "a word that nobody could read back";
    loseLink();
    giveLinkBack();
    EXPECT_EQ(std::ranges::count(known(), true), 0);
    ring->bus->setOperate(true);
    ring->bus->advance(2s);
    EXPECT_EQ(ring->gateway->out()[1], 0x4000'0001u);
    ring->bus->alarmStop();
    ring->bus->advance(100ms);
    EXPECT_TRUE(ring->isOutZero()) << "that was asked for everywhere";
}

TEST_F(GatewayRing, AJobIsRefusedWithTheReasonWhyTheLinkIsLost)
{
    open(EncoderBus::Start::operating);
    loseLink();
    const auto started = ring->encoder(writtenPlace).start(ReadParameters{{Parameter::steps}});
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().kind, RefusalKind::link);
    EXPECT_EQ(started.error().id, RefusalId::connectionClosed);
}

TEST_F(GatewayRing, ASingleExceptionDoesNotSwitchReadingBackOff)
{
    open(EncoderBus::Start::operating);
    write(ownWord);
    loseLink();
    port->make({.exception = 0.3});
    ring->bus->advance(60s);
    giveLinkBack();
    EXPECT_TRUE(ring->bus->latest().devices.front().outIsKnown);
    EXPECT_FALSE(isTold(GatewayRefusalId::outNotReadBack));
}

TEST_F(GatewayRing, TwoRingsOnTwoGatewaysHaveNothingToDoWithEachOther)
{
    open(EncoderBus::Start::operating);
    GatewaySession other({.id = BusId{2}});
    ASSERT_TRUE(other.bus->open(EncoderBus::Start::operating));
    write(ownWord);
    other.bus->advance(200ms);
    EXPECT_EQ(outThere(), ownWord);
    EXPECT_TRUE(other.isOutZero());
    loseLink();
    other.bus->advance(200ms);
    EXPECT_EQ(other.bus->state(), BusState::open);
    EXPECT_TRUE(other.bus->isOperating());
}

// With its own thread, which has no period: the link has its pace.
class GatewayThread : public testing::Test
{
protected:
    void open(
        const GatewaySettings &settings, SleepWatch::Slept slept = [] { return 0ms; })
    {
        ring = std::make_unique<GatewaySession>(GatewayMaking{.settings = settings},
                                                [](std::unique_ptr<RegisterPort> made) {
                                                    auto &its = static_cast<SimulatedGatewayPort &>(*made);
                                                    its.goByRealTime();
                                                    return made;
                                                });
        ASSERT_TRUE(ring->bus->open(EncoderBus::Start::operating, Pacing{.slept = std::move(slept)}));
        pumpUntil([this] { return ring->bus->isOpen() && ring->bus->latest().cycle > 0; });
    }
    template <typename Condition>
    void pumpUntil(Condition isSo)
    {
        const auto end = std::chrono::steady_clock::now() + 60s;
        while (!isSo() && std::chrono::steady_clock::now() < end) {
            ring->bus->pump();
            std::this_thread::sleep_for(1ms);
        }
        ASSERT_TRUE(isSo());
    }

    std::unique_ptr<GatewaySession> ring;
};

TEST_F(GatewayThread, ExchangesWithoutAPeriodAndCarriesOutAJob)
{
    open({});
    std::optional<Outcome> outcome;
    QObject::connect(&ring->encoder(writtenPlace), &EncoderSession::finished, ring->bus.get(),
                     [&](const Outcome &ended) { outcome = ended; });
    pumpUntil([this] { return ring->encoder(writtenPlace).freshness().isLive(); });
    ASSERT_TRUE(ring->encoder(writtenPlace)
                    .start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    pumpUntil([&] { return outcome.has_value(); });
    EXPECT_EQ(whyOf(*outcome), "");
    EXPECT_EQ(ring->bus->latest().lateCycles, 0u);
    ring->bus->close();
}

// The interval is much longer than the test may take.
TEST_F(GatewayThread, AnAlarmStopGoesOutLongBeforeTheNextPoll)
{
    open({.pollInterval = 10min});
    const std::uint64_t cycle = ring->bus->latest().cycle;
    ring->bus->alarmStop();
    pumpUntil([this] { return ring->countOf(RingMessageId::zerosReadBack) == 1; });
    EXPECT_LE(ring->bus->latest().cycle, cycle + 2);
    ring->bus->setRunning(false);
    pumpUntil([this] { return !ring->bus->isRunning(); });
    ring->bus->close();
}

TEST_F(GatewayThread, AfterTheComputerSleptTheBusIsInWatch)
{
    std::atomic<int> slept{0};
    open({}, [&slept] { return std::chrono::milliseconds(slept.exchange(0)); });
    pumpUntil([this] { return ring->bus->isOperating(); });
    slept = 3'600'000;
    pumpUntil([this] { return ring->countOf(MessageId::computerSlept) == 1; });
    pumpUntil([this] { return !ring->bus->isOperating(); });
    ring->bus->close();
}

TEST_F(GatewayThread, WhileTheComputerSleptIsAGapInTheHistory)
{
    std::atomic<int> slept{0};
    open({}, [&slept] { return std::chrono::milliseconds(slept.exchange(0)); });
    EncoderHistory kept;
    QObject::connect(&ring->encoder(writtenPlace), &EncoderSession::shown, ring->bus.get(),
                     [&](const ShownSeries &shown) {
                         for (ShownValues values : shown) {
                             values.at = ring->bus->sinceEpoch(values.at);
                             kept.add(values);
                         }
                     });
    const MemoryHistory &in = kept.of(Channel::in);
    pumpUntil([&] { return in.newest().has_value(); });
    slept = 3'600'000;
    pumpUntil([this] { return ring->countOf(MessageId::computerSlept) == 1; });
    pumpUntil([&] { return !in.gaps().empty() && in.newest().has_value(); });
    ASSERT_EQ(in.gaps().size(), 1U);
    EXPECT_GE(in.gaps().front().to - in.gaps().front().from, 1h);
    ring->bus->close();
}

// Refuses to write while its watchdog has tripped (exception 4), until that is acknowledged.
class WatchdogPort final : public PassingPort
{
public:
    struct Control
    {
        bool hasTripped = false;
        int acknowledged = 0;
    };
    static constexpr int at = 500;
    static constexpr Register value = 7;

    WatchdogPort(std::unique_ptr<RegisterPort> port, std::shared_ptr<Control> control)
        : PassingPort(std::move(port))
        , m_control(std::move(control))
    {}

    Done write(int first, std::span<const Register> from) override
    {
        if (first == at && from.size() == 1 && from[0] == value) {
            ++m_control->acknowledged;
            m_control->hasTripped = false;
            return {};
        }
        if (m_control->hasTripped)
            return tl::unexpected(RegisterError{RegisterError::Kind::exception, 4, {}});
        return PassingPort::write(first, from);
    }

private:
    std::shared_ptr<Control> m_control;
};

class TrippedWatchdog : public testing::Test
{
protected:
    void open(const GatewaySettings &settings)
    {
        session = std::make_unique<GatewaySession>(
            GatewayMaking{.settings = settings}, [this](std::unique_ptr<RegisterPort> port) {
                return std::make_unique<WatchdogPort>(std::move(port), control);
            });
        ASSERT_TRUE(session->bus->open(EncoderBus::Start::operating));
        session->bus->advance(1s);
        control->hasTripped = true;
        session->bus->advance(3s);
        ASSERT_EQ(session->bus->state(), BusState::open) << "it is back, and only reads";
    }
    bool isOffered() const
    {
        return std::ranges::any_of(session->bus->outline().faults(), [](const Fault &fault) {
            return fault.actions == std::vector{FaultAction::acknowledge};
        });
    }

    std::shared_ptr<WatchdogPort::Control> control = std::make_shared<WatchdogPort::Control>();
    std::unique_ptr<GatewaySession> session;
};

TEST_F(TrippedWatchdog, IsNamedAndAcknowledgedWhenTheUserSaysSo)
{
    open({.watchdogRegister = WatchdogPort::at, .watchdogValue = WatchdogPort::value});
    EXPECT_TRUE(std::ranges::any_of(session->messages, [](const Message &message) {
        return message.refusal && message.refusal->id == GatewayRefusalId::outputsBlocked;
    }));
    EXPECT_TRUE(isOffered());
    EXPECT_EQ(session->bus->outline().state(), (StateWord{Role::fault, QStringLiteral("outputs blocked")}));
    const DataChecks checks = session->bus->dataChecks({}, {});
    EXPECT_EQ(findCheck(checks, DataCheck::Id::gateway)->outcome, DataCheck::Outcome::differs);
    session->bus->advance(10s);
    EXPECT_EQ(control->acknowledged, 0) << "nobody has asked for it";
    session->bus->acknowledgeWatchdog();
    session->bus->advance(1s);
    EXPECT_EQ(control->acknowledged, 1);
    EXPECT_EQ(session->countOf(RingMessageId::watchdogAcknowledged), 1u);
    EXPECT_FALSE(isOffered());
    session->bus->setOperate(true);
    session->bus->advance(1s);
    EXPECT_TRUE(session->bus->isOperating());
}

TEST_F(TrippedWatchdog, ThatHasNoRegisterCannotBeAcknowledged)
{
    open({});
    EXPECT_TRUE(isOffered());
    session->bus->acknowledgeWatchdog();
    session->bus->advance(1s);
    EXPECT_EQ(session->lastRefusal()->id, GatewayRefusalId::watchdogNotSet);
    EXPECT_EQ(control->acknowledged, 0);
}

// The link is not lost, and the way out stays offered.
TEST_F(TrippedWatchdog, ZerosOfAnAlarmStopWaitUntilItIsAcknowledged)
{
    session =
        std::make_unique<GatewaySession>(GatewayMaking{.settings = {.watchdogRegister = WatchdogPort::at,
                                                                    .watchdogValue = WatchdogPort::value}},
                                         [this](std::unique_ptr<RegisterPort> port) {
                                             return std::make_unique<WatchdogPort>(std::move(port), control);
                                         });
    ASSERT_TRUE(session->bus->open(EncoderBus::Start::operating));
    session->bus->channel("1.0"_ring)->stage(0x2021'0001);
    session->bus->channel("1.0"_ring)->write();
    session->bus->advance(1s);
    control->hasTripped = true;
    session->bus->alarmStop();
    session->bus->advance(5s);
    EXPECT_EQ(session->bus->state(), BusState::open);
    EXPECT_EQ(session->countOf(RingMessageId::linkBack), 0u);
    EXPECT_TRUE(isOffered());
    EXPECT_TRUE(session->bus->waitsForZeros());
    EXPECT_EQ(session->bus->channel("1.0"_ring)->out(), 0x2021'0001u) << "that is what the gateway has";
    session->bus->acknowledgeWatchdog();
    session->bus->advance(2s);
    EXPECT_EQ(session->countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_TRUE(session->isOutZero());
    EXPECT_FALSE(session->bus->waitsForZeros());
    EXPECT_FALSE(isOffered());
}

// Each answer comes after its time-out, though each request arrives.
class UnheardPort final : public PassingPort
{
public:
    explicit UnheardPort(std::unique_ptr<RegisterPort> port, std::shared_ptr<bool> isLate)
        : PassingPort(std::move(port))
        , m_isLate(std::move(isLate))
    {}

    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        return late(PassingPort::read(area, first, to));
    }
    Done write(int first, std::span<const Register> from) override
    {
        return late(PassingPort::write(first, from));
    }

private:
    Done late(Done done)
    {
        if (!*m_isLate)
            return done;
        wait(now() + 500ms);
        return tl::unexpected(RegisterError{.kind = RegisterError::Kind::noAnswer, .isLate = true});
    }

    std::shared_ptr<bool> m_isLate;
};

class ZerosOverALostLink : public testing::Test
{
protected:
    ZerosOverALostLink()
    {
        EXPECT_TRUE(session.bus->open(EncoderBus::Start::operating));
        session.bus->channel("1.0"_ring)->stage(0x2021'0001);
        session.bus->channel("1.0"_ring)->write();
        session.bus->advance(1s);
        *isLate = true;
        session.bus->advance(10s);
        EXPECT_EQ(session.bus->state(), BusState::lost);
    }

    std::shared_ptr<bool> isLate = std::make_shared<bool>(false);
    GatewaySession session{{}, [this](std::unique_ptr<RegisterPort> port) {
                               return std::make_unique<UnheardPort>(std::move(port), isLate);
                           }};
};

TEST_F(ZerosOverALostLink, AreSentThoughNobodyAnswers)
{
    session.bus->alarmStop();
    session.bus->advance(5s);
    EXPECT_TRUE(session.isOutZero());
    EXPECT_EQ(session.countOf(RingMessageId::zerosUnheard), 1u) << "told once";
    EXPECT_TRUE(session.bus->waitsForZeros());
    EXPECT_FALSE(session.bus->channel("1.0"_ring)->outIsKnown());
    *isLate = false;
    session.bus->advance(5s);
    EXPECT_EQ(session.countOf(RingMessageId::zerosReadBack), 1u);
    EXPECT_FALSE(session.bus->waitsForZeros());
}

// A controller that writes its image in each of its cycles.
TEST(OverwrittenZeros, AreToldThoughTheyHadArrived)
{
    GatewaySession session;
    ASSERT_TRUE(session.bus->open(EncoderBus::Start::watching));
    session.bus->advance(1s);
    session.bus->alarmStop();
    session.bus->advance(500ms);
    ASSERT_EQ(session.countOf(RingMessageId::zerosReadBack), 1u);
    session.gateway->setOut(0, 0x2021'0001);
    session.bus->advance(2s);
    EXPECT_EQ(session.countOf(RingMessageId::zerosOverwritten), 1u);
    session.gateway->setOut(0, 0x2021'0002);
    session.bus->advance(5s);
    EXPECT_EQ(session.countOf(RingMessageId::zerosOverwritten), 1u) << "told once";
}

TEST_F(ZerosOverALostLink, AreGivenUpAloud)
{
    session.bus->alarmStop();
    session.bus->advance(1s);
    session.bus->close();
    EXPECT_EQ(session.countOf(RingMessageId::zerosGivenUp), 1u);
    EXPECT_FALSE(session.bus->waitsForZeros());
}

TEST_F(ZerosOverALostLink, AreNotSentUnasked)
{
    session.bus->advance(10s);
    EXPECT_FALSE(session.isOutZero());
    session.bus->close();
    EXPECT_EQ(session.countOf(RingMessageId::zerosGivenUp), 0u);
}

// Hangs in a write until it is released, whoever interrupts it.
class HangingPort final : public PassingPort
{
public:
    struct Control
    {
        std::atomic<bool> hangs = false;
    };

    HangingPort(std::unique_ptr<RegisterPort> port, std::shared_ptr<Control> control)
        : PassingPort(std::move(port))
        , m_control(std::move(control))
    {}

    Done write(int first, std::span<const Register> from) override
    {
        while (m_control->hangs)
            std::this_thread::sleep_for(1ms);
        return PassingPort::write(first, from);
    }
    Instant now() const override { return std::chrono::duration_cast<Instant>(Clock::now() - m_begin); }
    void wait(Instant until) override { std::this_thread::sleep_until(m_begin + until); }
    void interrupt() override {}

private:
    using Clock = std::chrono::steady_clock;

    std::shared_ptr<Control> m_control;
    const Clock::time_point m_begin = Clock::now();
};

TEST(GatewayThatHangs, ZerosThatHaveNotArrivedAreToldWithinASecondAndTriedOn)
{
    const auto control = std::make_shared<HangingPort::Control>();
    GatewaySession session({}, [&](std::unique_ptr<RegisterPort> port) {
        return std::make_unique<HangingPort>(std::move(port), control);
    });
    RingSession &bus = *session.bus;
    ASSERT_TRUE(bus.open(EncoderBus::Start::operating));
    bus.startThread({});
    const auto waitFor = [&](const auto &isSo) {
        for (int i = 0; i < 500 && !isSo(); ++i) {
            std::this_thread::sleep_for(10ms);
            bus.pump();
        }
        return isSo();
    };
    ASSERT_TRUE(waitFor([&] { return bus.latest().cycle > 3; }));
    control->hangs = true;
    bus.alarmStop();
    EXPECT_TRUE(waitFor([&] { return session.countOf(RingMessageId::zerosLate) == 1; }));
    EXPECT_TRUE(bus.areZerosLate());
    EXPECT_TRUE(bus.waitsForZeros());
    EXPECT_TRUE(std::ranges::any_of(bus.outline().faults(), [](const Fault &fault) {
        return fault.shown.role == Role::fault && fault.extent == Fault::Extent::bus;
    }));
    control->hangs = false;
    EXPECT_TRUE(waitFor([&] { return session.countOf(RingMessageId::zerosReadBack) == 1; }));
    EXPECT_FALSE(bus.areZerosLate());
    EXPECT_EQ(session.countOf(RingMessageId::zerosLate), 1u);
    EXPECT_TRUE(std::ranges::is_sorted(session.messages, {}, &Message::at)) << "they arrived after that";
    bus.close();
}

// The exchange that saw it was given up because of it, and the next one takes its time.
TEST(SlowGatewayRing, AnAlarmStopNamesTheWordThatSomebodyElseHasJustWritten)
{
    test::GatewaySession slow({.settings = {.timeOut = 2s}, .transaction = 400ms});
    ASSERT_TRUE(slow.bus->open(EncoderBus::Start::operating));
    slow.bus->advance(10s);
    ASSERT_TRUE(slow.bus->isOperating());
    slow.gateway->setOut(0, foreignWord);
    const auto isSeen = [&] {
        const auto last = slow.lastRefusal();
        return last && last->id == GatewayRefusalId::outNotOurs;
    };
    const Instant written = slow.bus->now();
    while (!isSeen() && slow.bus->now() < written + 60s)
        slow.bus->advance(100ms);
    ASSERT_TRUE(isSeen());
    EXPECT_GT(slow.messages.back().at, written) << "not from when the exchange began";
    slow.bus->alarmStop();
    EXPECT_EQ(slow.bus->outBeforeZeros(), QStringLiteral("1.0 04000001 (register 0)"));
    EXPECT_EQ(slow.messages.back().id, RingMessageId::zerosAsked);
    slow.bus->advance(10s);
    EXPECT_TRUE(slow.isOutZero());
}

// Asked for in the middle of a read. `reads` behind it, until something is written.
class AlarmedPort final : public PassingPort
{
public:
    struct Control
    {
        std::function<void()> alarm; // called once
        int reads = 0;
        std::vector<Register> written{};
    };

    AlarmedPort(std::unique_ptr<RegisterPort> port, std::shared_ptr<Control> control)
        : PassingPort(std::move(port))
        , m_control(std::move(control))
    {}

    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        const bool isBehind = m_isAlarmed && m_control->written.empty();
        m_control->reads += isBehind ? 1 : 0;
        if (m_control->alarm) {
            m_isAlarmed = true;
            std::exchange(m_control->alarm, {})();
        }
        return PassingPort::read(area, first, to);
    }
    Done write(int first, std::span<const Register> from) override
    {
        if (m_isAlarmed && m_control->written.empty())
            m_control->written.assign(from.begin(), from.end());
        return PassingPort::write(first, from);
    }

private:
    std::shared_ptr<Control> m_control;
    bool m_isAlarmed = false;
};

TEST(SlowGatewayRing, OnlyTheTransactionUnderWayGoesBeforeZeros)
{
    for (const auto start : {EncoderBus::Start::watching, EncoderBus::Start::operating})
        for (const Instant after : {0ms, 500ms, 900ms, 1300ms}) {
            SCOPED_TRACE(std::chrono::duration_cast<std::chrono::milliseconds>(after).count());
            const auto control = std::make_shared<AlarmedPort::Control>();
            GatewaySession slow({.settings = {.timeOut = 2s}, .transaction = 400ms},
                                [&](std::unique_ptr<RegisterPort> port) {
                                    return std::make_unique<AlarmedPort>(std::move(port), control);
                                });
            ASSERT_TRUE(slow.bus->open(start));
            slow.bus->advance(10s + after);
            control->alarm = [&] { slow.bus->alarmStop(); };
            slow.bus->advance(10s);
            EXPECT_EQ(control->reads, 0);
            EXPECT_FALSE(control->written.empty());
            EXPECT_TRUE(std::ranges::all_of(control->written, [](Register half) { return half == 0; }));
            EXPECT_EQ(slow.countOf(RingMessageId::zerosReadBack), 1u);
        }
}

// Hears, and answers nothing any more. ALARM STOP comes within a read of it.
class MutePort final : public PassingPort
{
public:
    struct Control
    {
        bool isMute = false;
        std::function<void()> alarm{}; // called once
        std::string calls{};           // since then: r, w
    };

    MutePort(std::unique_ptr<RegisterPort> port, std::shared_ptr<Control> control)
        : PassingPort(std::move(port))
        , m_control(std::move(control))
    {}

    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        m_control->calls += 'r';
        if (m_control->isMute && m_control->alarm) {
            std::exchange(m_control->alarm, {})();
            m_control->calls.clear();
        }
        return m_control->isMute ? silence() : PassingPort::read(area, first, to);
    }
    Done write(int first, std::span<const Register> from) override
    {
        m_control->calls += 'w';
        (void)PassingPort::write(first, from);
        return m_control->isMute ? silence() : Done();
    }

private:
    Done silence()
    {
        wait(now() + 500ms);
        return tl::unexpected(RegisterError{RegisterError::Kind::noAnswer, 0, {}});
    }

    std::shared_ptr<Control> m_control;
};

TEST(MuteGatewayRing, ZerosOfALostLinkGoBeforeAnythingIsAsked)
{
    for (const Instant lostFor : {0s, 20s}) {
        SCOPED_TRACE(lostFor.count());
        const auto control = std::make_shared<MutePort::Control>();
        GatewaySession mute({}, [&](std::unique_ptr<RegisterPort> port) {
            return std::make_unique<MutePort>(std::move(port), control);
        });
        ASSERT_TRUE(mute.bus->open(EncoderBus::Start::operating));
        mute.bus->advance(1s);
        mute.gateway->setOut(0, foreignWord);
        control->isMute = true;
        mute.bus->advance(lostFor);
        control->alarm = [&] { mute.bus->alarmStop(); };
        mute.bus->advance(5s);
        ASSERT_FALSE(control->alarm);
        EXPECT_EQ(control->calls.front(), 'w') << control->calls;
        EXPECT_TRUE(mute.isOutZero());
        EXPECT_EQ(mute.countOf(RingMessageId::zerosUnheard), 1u);
    }
}

// In Watch as well as in Operate. IN and OUT are read behind the write.
TEST(SlowGatewayRing, ZerosHaveArrivedWhenTheyWereReadBack)
{
    constexpr Instant transaction = 400ms;
    for (const auto start : {EncoderBus::Start::watching, EncoderBus::Start::operating}) {
        test::GatewaySession slow({.settings = {.timeOut = 2s}, .transaction = transaction});
        ASSERT_TRUE(slow.bus->open(start));
        slow.bus->advance(10s);
        const Instant asked = slow.bus->now();
        slow.bus->alarmStop();
        slow.bus->advance(10s);
        const auto told = std::ranges::find(slow.messages, RingMessageId::zerosReadBack, &Message::id);
        ASSERT_NE(told, slow.messages.end());
        EXPECT_GE(told->at, asked + 3 * transaction);
        EXPECT_TRUE(std::ranges::is_sorted(slow.messages, {}, &Message::at));
    }
}

constexpr Place seldomSeen = "1.0"_ring;

// Three polls are too far apart to say that a position moves: the reads of one have to do.
TEST(SeldomPolledGateway, ATurningShaftIsSeen)
{
    test::GatewaySession gateway({.ways = {.copyApart = 1ms}, .settings = {.pollInterval = 500ms}});
    ASSERT_TRUE(gateway.bus->open(EncoderBus::Start::watching));
    gateway.encoder(seldomSeen).tell(Parameter::startUpMode, 1);
    for (const int speed : {300, -40, 1500}) {
        SCOPED_TRACE(speed);
        gateway.training.controls->setSpeed(seldomSeen.node, speed);
        gateway.bus->advance(2s);
        for (int poll = 0; poll < 20; ++poll) {
            gateway.bus->advance(500ms);
            const auto &shown = gateway.bus->latest().devices.front();
            EXPECT_EQ(gateway.bus->outline().state(0).shown.word, QLatin1String("ok"));
            EXPECT_TRUE(gateway.encoder(seldomSeen).freshness().isLive());
            EXPECT_TRUE(gateway.gateway->wasIn(0, shown.in, gateway.bus->now() - 1200ms));
        }
    }
}

TEST(SeldomPolledGateway, AShaftThatTurnsFasterThanItAnswersIsUnsettledAndNotCutOff)
{
    test::GatewaySession gateway({.settings = {.timeOut = 2s}, .transaction = 700ms});
    ASSERT_TRUE(gateway.bus->open(EncoderBus::Start::watching));
    gateway.bus->advance(20s); // it stands, and is seen
    EXPECT_TRUE(gateway.encoder(seldomSeen).freshness().isLive());
    gateway.training.controls->setSpeed(seldomSeen.node, 600);
    gateway.bus->advance(120s);
    const NodeState state = gateway.bus->outline().state(0);
    EXPECT_EQ(state.shown.word, QLatin1String("unsettled"));
    EXPECT_FALSE(state.isCutOff);
    EXPECT_FALSE(state.isBehindBreak);
    EXPECT_EQ(gateway.encoder(seldomSeen).freshness().reason(), Freshness::Reason::unsettled);
}

} // namespace
} // namespace codewheel
