// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of every bus (bus/encoder_bus.h), on its simulator: in virtual time, or with its thread.
#include "bus/buses.h"
#include "can/simulator/simulated_can_link.h"
#include "catalog/catalog.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/simulated_ring.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/bus/watched_links.h"
#include "tests/support/places.h"
#include "tests/support/simulated_gateway.h"

#include <QPointer>

#include <algorithm>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const Catalog &catalog()
{
    static const Catalog builtIn = Catalog::builtIn();
    return builtIn;
}

const QDateTime began(QDate(2026, 3, 1), QTime(14, 2));

struct Ring
{
    static constexpr Place place = "1.0"_ring;
    static constexpr bool isSimulated = true;
    static constexpr int positionsInASecond = 1'000;
    static constexpr std::int64_t steps = 255;

    Result<void> open(EncoderBus::Start start)
    {
        return bus.open(start).map([this] {
            bus.encoder(place)->tell(Parameter::startUpMode, 1); // position mode
        });
    }
    void openByThread() { ASSERT_TRUE(bus.open(EncoderBus::Start::watching, Pacing{.period = 1ms})); }

    test::LinkWatch watch;
    RingSession bus{std::make_unique<test::WatchedRingLink>(makeTrainingBus(catalog()).link, watch),
                    catalog(), began};
};

// The same ring behind a gateway that tears words.
struct Gateway
{
    static constexpr Place place = "1.0"_ring;
    static constexpr bool isSimulated = false;
    static constexpr int positionsInASecond = 300;
    static constexpr std::int64_t steps = 255;

    Gateway()
        : Gateway(std::dynamic_pointer_cast<SimulatedRing>(makeTrainingBus(catalog()).controls))
    {}
    explicit Gateway(const std::shared_ptr<SimulatedRing> &ring)
        : Gateway(ring, std::make_unique<test::SimulatedGatewayPort>(std::make_shared<test::SimulatedGateway>(
                            ring, test::SimulatedGateway::Ways{.tears = 0.2, .lag = 5ms})))
    {}
    Gateway(const std::shared_ptr<SimulatedRing> &ring, std::unique_ptr<test::SimulatedGatewayPort> made)
        : port(made.get())
        , bus(std::make_unique<test::WatchedRingLink>(
                  std::make_unique<GatewayLink>(std::move(made), GatewaySettings{.pollInterval = {}},
                                                test::gatewayDevices(*ring, catalog())),
                  watch),
              catalog(), began)
    {}
    Result<void> open(EncoderBus::Start start)
    {
        return bus.open(start).map([this] {
            bus.encoder(place)->tell(Parameter::startUpMode, 1); // position mode
        });
    }
    void openByThread()
    {
        bus.close();
        port->goByRealTime();
        ASSERT_TRUE(bus.open(EncoderBus::Start::watching, Pacing{}));
    }

    test::LinkWatch watch;
    test::SimulatedGatewayPort *port;
    RingSession bus;
};

struct Line
{
    static constexpr Place place = placeOnLine({5});
    static constexpr bool isSimulated = true;
    static constexpr int positionsInASecond = 40;
    static constexpr std::int64_t steps = 864;

    Result<void> open(EncoderBus::Start start)
    {
        return bus.open({}, {}, start, EncoderBus::Drive::byHand).and_then([this] { return addEncoder(); });
    }
    void openByThread()
    {
        ASSERT_TRUE(bus.open({}, {}, EncoderBus::Start::watching, EncoderBus::Drive::byThread));
        ASSERT_TRUE(addEncoder());
    }
    Result<void> addEncoder() { return bus.add({5}, QStringLiteral("kuebler-esc-rs485")); }

    test::LinkWatch watch;
    EscLineSession bus{
        std::make_unique<test::WatchedLineLink>(
            std::make_unique<SimulatedEscLineLink>(std::make_shared<SimulatedEscLine>()), watch),
        catalog(), began, [](const DeviceDescription &device, EscLineAddress address) {
            return std::make_unique<EscDriver>(device, address);
        }};
};

// In Watch its nodes are heard, but nobody may ask them what their PDOs hold.
struct Can
{
    static constexpr Place place{firstCanBus, NodeId("can:6")};
    static constexpr bool isSimulated = true;
    static constexpr int positionsInASecond = 20;
    static constexpr std::int64_t steps = 3'600;

    Result<void> open(EncoderBus::Start start)
    {
        return bus.open({}, start, EncoderBus::Drive::byHand).and_then([this] { return addEncoder(); });
    }
    void openByThread()
    {
        ASSERT_TRUE(bus.open({}, EncoderBus::Start::watching, EncoderBus::Drive::byThread));
        ASSERT_TRUE(addEncoder());
    }
    Result<void> addEncoder() { return bus.add(6, QStringLiteral("canopen-406-multi-turn")); }
    static std::vector<canopen::CanopenEncoderPlan> encoders()
    {
        auto plans = canopen::trainingEncoders();
        for (canopen::CanopenEncoderPlan &plan : plans)
            plan.quirks.startsItself = true;
        return plans;
    }

    test::LinkWatch watch;
    canopen::SimulatedCanopenPlant plant{encoders()};
    CanopenSession bus{
        std::make_unique<test::WatchedCanBusLink>(std::make_unique<SimulatedCanLink>(plant.bus()), watch),
        catalog(), began};
};

template <class Kind>
constexpr bool asksInWatch = !std::is_same_v<Kind, Can>;

template <class Kind>
class EncoderBusContract : public testing::Test
{
protected:
    EncoderBus &bus() { return m_kind.bus; }
    EncoderSession &encoder() { return *bus().encoder(Kind::place); }
    test::LinkWatch &watch() { return m_kind.watch; }
    int changes() const { return m_kind.watch.changes; }

    void open(bool operating)
    {
        m_outcome.reset();
        ASSERT_TRUE(m_kind.open(operating ? EncoderBus::Start::operating : EncoderBus::Start::watching));
        bus().advance(asksInWatch<Kind> ? 100ms : 500ms);
        QObject::connect(&encoder(), &EncoderSession::finished, &bus(),
                         [this](const Outcome &outcome) { m_outcome = outcome; });
    }
    // As far as it is asked for what it shows.
    bool isLive() { return encoder().freshness().isLive() || (!asksInWatch<Kind> && !bus().isOperating()); }
    Result<void> tryToOpen() { return m_kind.open(EncoderBus::Start::operating); }
    void openByThread() { m_kind.openByThread(); }
    // With its thread: time passes by itself.
    template <typename Condition>
    void pumpUntil(Condition isSo)
    {
        const auto end = std::chrono::steady_clock::now() + 60s;
        while (!isSo() && std::chrono::steady_clock::now() < end) {
            bus().pump();
            std::this_thread::sleep_for(1ms);
        }
        ASSERT_TRUE(isSo());
    }
    void pumpUntilState(BusState wanted)
    {
        pumpUntil([&] { return bus().state() == wanted; });
    }
    Result<JobId> start()
    {
        return encoder().start(WriteParameters{.values = {{Parameter::steps, Kind::steps}}, .previous = {}});
    }
    void finish()
    {
        for (int i = 0; i < 1000 && !m_outcome; ++i)
            bus().advance(10ms);
        ASSERT_TRUE(m_outcome);
        EXPECT_FALSE(encoder().runningJob());
    }
    RefusalCode whyItEnded() const
    {
        return m_outcome->result ? RefusalId::nothingToDo : m_outcome->result.error().id;
    }

    std::optional<Outcome> m_outcome;

private:
    Kind m_kind;
};

using Kinds = testing::Types<Ring, Gateway, Line, Can>;
TYPED_TEST_SUITE(EncoderBusContract, Kinds);

TYPED_TEST(EncoderBusContract, WatchSendsNothingThatChangesAnything)
{
    this->open(false);
    EXPECT_TRUE(this->bus().isOpen());
    EXPECT_TRUE(this->bus().isRunning());
    EXPECT_EQ(this->bus().isSimulated(), TypeParam::isSimulated);
    EXPECT_FALSE(this->bus().isOperating());
    EXPECT_EQ(this->start().error().id, RefusalId::watchOnly);
    this->bus().advance(1s);
    EXPECT_EQ(this->changes(), 0);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, OperateIsToldAndLetsAJobOut)
{
    this->open(false);
    int told = 0;
    QObject::connect(&this->bus(), &EncoderBus::stateChanged, &this->bus(), [&] { ++told; });
    this->bus().setOperate(true);
    this->bus().advance(50ms);
    EXPECT_EQ(told, 1);
    ASSERT_TRUE(this->start());
    this->finish();
    EXPECT_TRUE(this->m_outcome->result);
    EXPECT_GT(this->changes(), 0);
    EXPECT_EQ(this->encoder().known(Parameter::steps)->value, TypeParam::steps);
    EXPECT_EQ(this->encoder().eepromWrites(), this->m_outcome->eepromWrites);
}

TYPED_TEST(EncoderBusContract, AJobEndsWheneverItIsCancelled)
{
    int cancelled = 0;
    bool isCancelled = true;
    for (auto after = 0ms; isCancelled && after < 10s; after += 3ms) {
        this->open(true);
        ASSERT_TRUE(this->start());
        this->bus().advance(after);
        isCancelled = this->encoder().runningJob().has_value();
        this->encoder().cancel(OnCancel::leaveAsIs);
        this->finish();
        cancelled += this->whyItEnded() == RefusalId::cancelled ? 1 : 0;
        this->bus().close();
    }
    EXPECT_FALSE(isCancelled) << "at last it is over before";
    EXPECT_GT(cancelled, 3);
}

TYPED_TEST(EncoderBusContract, AlarmStopEndsJobsAndNothingFollows)
{
    this->open(true);
    ASSERT_TRUE(this->start());
    this->bus().advance(5ms);
    this->bus().alarmStop();
    this->finish();
    EXPECT_EQ(this->whyItEnded(), RefusalId::alarmStop);
    const int before = this->changes();
    this->bus().advance(1s);
    EXPECT_EQ(this->changes(), before);
    EXPECT_TRUE(devicesWithOut(this->bus()).empty());
}

TYPED_TEST(EncoderBusContract, WhatIsShownGrowsOldOnceItStops)
{
    this->open(!asksInWatch<TypeParam>);
    this->bus().setRunning(false);
    this->bus().advance(50ms);
    EXPECT_FALSE(this->bus().isRunning());
    EXPECT_EQ(this->encoder().freshness().reason(), Freshness::Reason::stopped);
    this->bus().setRunning(true);
    this->bus().advance(50ms);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, EveryPositionIsShownInOrderAndTheEndOfThem)
{
    this->open(!asksInWatch<TypeParam>);
    ShownSeries shown;
    QObject::connect(
        &this->encoder(), &EncoderSession::shown, &this->bus(),
        [&](const ShownSeries &positions) { shown.insert(shown.end(), positions.begin(), positions.end()); });
    const auto isBefore = [](const ShownValues &one, const ShownValues &other) { return one.at < other.at; };
    for (int frame = 0; frame < 30; ++frame)
        this->bus().advance(33ms);
    EXPECT_GE(shown.size(), TypeParam::positionsInASecond * 0.95);
    EXPECT_TRUE(std::ranges::is_sorted(shown, isBefore));
    EXPECT_EQ(std::ranges::adjacent_find(shown, {}, &ShownValues::at), shown.end()) << "each once";
    EXPECT_EQ(shown.back().at, this->encoder().latest().at);
    EXPECT_EQ(shown.back().position, this->encoder().latest().position);

    this->bus().setRunning(false);
    this->bus().advance(200ms);
    EXPECT_FALSE(shown.back().position);
    const std::size_t atRest = shown.size();
    this->bus().advance(200ms);
    EXPECT_EQ(shown.size(), atRest);
    this->bus().setRunning(true);
    this->bus().advance(200ms);
    EXPECT_TRUE(shown.back().position);
    EXPECT_TRUE(std::ranges::is_sorted(shown, isBefore));
}

TYPED_TEST(EncoderBusContract, ClosingEndsAJobAndTheSessionStays)
{
    this->open(true);
    ASSERT_TRUE(this->start());
    this->bus().advance(5ms);
    this->bus().close();
    EXPECT_FALSE(this->bus().isOpen());
    ASSERT_TRUE(this->m_outcome);
    EXPECT_FALSE(this->m_outcome->result);
    EXPECT_FALSE(this->encoder().runningJob());
    EXPECT_EQ(this->encoder().freshness().reason(), Freshness::Reason::disconnected);
    EXPECT_FALSE(this->start());
}

TYPED_TEST(EncoderBusContract, ALostLinkEndsTheJobAndComesBackInWatch)
{
    this->open(true);
    ASSERT_TRUE(this->start());
    this->bus().advance(5ms);
    const QPointer<EncoderSession> before = &this->encoder();
    this->watch().isGone = true;
    this->finish();
    EXPECT_FALSE(this->m_outcome->result);
    EXPECT_EQ(this->bus().state(), BusState::lost);
    EXPECT_TRUE(this->bus().isOpen());
    EXPECT_FALSE(this->bus().isRunning());
    EXPECT_FALSE(this->encoder().freshness().isLive());
    EXPECT_FALSE(this->start());

    this->bus().advance(3s);
    EXPECT_EQ(this->bus().state(), BusState::lost);
    this->watch().isGone = false;
    this->bus().advance(1100ms);
    EXPECT_EQ(this->bus().state(), BusState::open);
    EXPECT_TRUE(this->bus().isRunning());
    EXPECT_FALSE(this->bus().isOperating());
    EXPECT_EQ(&this->encoder(), before);
    EXPECT_TRUE(this->isLive());
    EXPECT_EQ(this->start().error().id, RefusalId::watchOnly);
}

TYPED_TEST(EncoderBusContract, ALostLinkThatIsBackSendsNothingByItself)
{
    this->open(true);
    this->watch().isGone = true;
    this->bus().advance(2s);
    this->bus().setOperate(true);
    this->watch().isGone = false;
    this->bus().advance(3s);
    EXPECT_EQ(this->bus().state(), BusState::open);
    EXPECT_FALSE(this->bus().isOperating()) << "whatever was asked of it meanwhile";
    EXPECT_EQ(this->changes(), 0);
}

TYPED_TEST(EncoderBusContract, EveryMessageTellsItsBus)
{
    int ofBus = 0;
    int ofDevice = 0;
    QObject::connect(&this->bus(), &EncoderBus::messaged, &this->bus(), [&](const Message &message) {
        ASSERT_TRUE(message.place);
        EXPECT_EQ(message.place->bus, this->bus().id());
        ++(message.place->isEmpty() ? ofBus : ofDevice);
    });
    this->open(true);
    this->bus().setOperate(false);
    this->bus().advance(100ms);
    this->bus().setOperate(true);
    this->bus().advance(100ms);
    ASSERT_TRUE(this->start());
    this->finish();
    this->bus().advance(100ms);
    EXPECT_GE(ofBus, 1);
    EXPECT_GE(ofDevice, 1);
    const int before = ofBus;
    this->watch().isGone = true;
    this->bus().advance(100ms);
    EXPECT_GT(ofBus, before) << "the link is lost";
}

TYPED_TEST(EncoderBusContract, RefusalsNameTheBusWhereSeveralHaveThePlace)
{
    setBusNames({{this->bus().id(), QStringLiteral("Crane")}});
    this->open(true);
    ASSERT_TRUE(this->start());
    const auto again = this->start();
    const auto named = this->bus().name(TypeParam::place, this->encoder().device().key);
    setBusNames({});
    const RefusalArgument place = QStringLiteral("Crane/%1").arg(TypeParam::place.toString());
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().arguments.front(), place);
    ASSERT_FALSE(named);
    EXPECT_EQ(named.error().id, RefusalId::jobRunning);
    EXPECT_EQ(named.error().arguments.front(), place);
}

TYPED_TEST(EncoderBusContract, ALinkThatDoesNotOpenIsTold)
{
    std::vector<RefusalCode> refused;
    std::vector<RefusalCode> messages;
    QObject::connect(&this->bus(), &EncoderBus::openRefused, &this->bus(),
                     [&](const Refusal &why) { refused.push_back(why.id); });
    QObject::connect(&this->bus(), &EncoderBus::messaged, &this->bus(), [&](const Message &message) {
        if (message.refusal)
            messages.push_back(message.refusal->id);
    });
    this->watch().isGone = true;
    const auto opened = this->tryToOpen();
    ASSERT_FALSE(opened);
    EXPECT_EQ(refused, std::vector{opened.error().id});
    EXPECT_EQ(messages, refused);
    EXPECT_EQ(this->bus().state(), BusState::closed);
    EXPECT_TRUE(this->bus().places().empty());
    this->bus().advance(3s);
    EXPECT_EQ(this->bus().state(), BusState::closed) << "it is for the user to try again";

    this->watch().isGone = false;
    this->open(false);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, AThreadOpensIt)
{
    int told = 0;
    QObject::connect(&this->bus(), &EncoderBus::stateChanged, &this->bus(), [&] { ++told; });
    this->openByThread();
    EXPECT_EQ(this->bus().state(), BusState::opening);
    EXPECT_FALSE(this->bus().isOpen());
    EXPECT_EQ(told, 1);
    this->pumpUntilState(BusState::open);
    EXPECT_EQ(told, 2);
    this->pumpUntil([this] { return this->isLive(); });
    EXPECT_TRUE(this->bus().isRunning());
    EXPECT_FALSE(this->bus().isOperating());
    this->bus().close();
    EXPECT_EQ(this->bus().state(), BusState::closed);
    EXPECT_EQ(this->changes(), 0);
}

TYPED_TEST(EncoderBusContract, ItIsOpenWithItsDevices)
{
    for (int i = 0; i < 100; ++i) {
        this->openByThread();
        while (!this->bus().isOpen())
            this->bus().pump();
        ASSERT_NE(this->bus().encoder(TypeParam::place), nullptr);
        this->bus().close();
    }
}

TYPED_TEST(EncoderBusContract, AThreadTellsThatTheLinkDoesNotOpen)
{
    std::vector<RefusalCode> refused;
    QObject::connect(&this->bus(), &EncoderBus::openRefused, &this->bus(),
                     [&](const Refusal &why) { refused.push_back(why.id); });
    this->watch().isGone = true;
    this->openByThread();
    this->pumpUntilState(BusState::closed);
    EXPECT_EQ(refused.size(), 1U);
    this->watch().isGone = false;
    this->openByThread();
    this->pumpUntilState(BusState::open);
    EXPECT_EQ(refused.size(), 1U);
}

TYPED_TEST(EncoderBusContract, AThreadTriesALostLinkAgain)
{
    this->openByThread();
    this->pumpUntilState(BusState::open);
    this->pumpUntil([this] { return this->isLive(); });
    this->watch().isGone = true;
    this->pumpUntilState(BusState::lost);
    this->watch().isGone = false;
    this->pumpUntilState(BusState::open);
    this->pumpUntil([this] { return this->isLive(); });
    EXPECT_EQ(this->changes(), 0);
}

TYPED_TEST(EncoderBusContract, ClosingWhileItOpensEndsThat)
{
    std::vector<RefusalCode> refused;
    QObject::connect(&this->bus(), &EncoderBus::openRefused, &this->bus(),
                     [&](const Refusal &why) { refused.push_back(why.id); });
    this->watch().blockOpening(true);
    for (int i = 0; i < 100; ++i) {
        this->openByThread();
        this->bus().pump();
        EXPECT_EQ(this->bus().state(), BusState::opening);
        this->bus().close();
        EXPECT_EQ(this->bus().state(), BusState::closed);
        this->bus().close();
    }
    EXPECT_TRUE(refused.empty()) << "who closes it knows";
    this->watch().blockOpening(false);
    this->openByThread();
    this->pumpUntilState(BusState::open);
}

TYPED_TEST(EncoderBusContract, ClosingAtAnyTimeOfOpeningIsRight)
{
    for (int i = 0; i < 200; ++i) {
        this->openByThread();
        std::this_thread::sleep_for(i * 5us);
        if (i % 2 == 0)
            this->bus().pump();
        this->bus().close();
        EXPECT_EQ(this->bus().state(), BusState::closed);
    }
    this->open(false);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, OpeningAgainWhileItOpensBeginsAnew)
{
    this->watch().blockOpening(true);
    this->openByThread();
    this->openByThread();
    EXPECT_EQ(this->bus().state(), BusState::opening);
    this->bus().close();
    this->watch().blockOpening(false);
    this->openByThread();
    this->openByThread();
    this->pumpUntilState(BusState::open);
    this->openByThread();
    EXPECT_EQ(this->bus().state(), BusState::opening);
    this->pumpUntilState(BusState::open);
}

TYPED_TEST(EncoderBusContract, AnInterruptionOfBeforeDoesNotKeepItFromOpening)
{
    this->watch().blockOpening(true);
    this->watch().interrupt();
    this->watch().blockOpening(false);
    this->open(false);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, EndsWhileItOpens)
{
    for (int i = 0; i < 20; ++i) {
        TypeParam kind;
        kind.watch.blockOpening(i % 2 == 0);
        kind.openByThread();
    }
}

TYPED_TEST(EncoderBusContract, AHandlerMayOpenItAgainAsItCloses)
{
    this->open(true);
    ASSERT_TRUE(this->start());
    this->bus().advance(5ms);
    bool isOpened = false;
    QObject scope;
    QObject::connect(&this->bus(), &EncoderBus::messaged, &scope, [&] {
        if (std::exchange(isOpened, true))
            return;
        EXPECT_TRUE(this->tryToOpen());
    });
    this->bus().close();
    EXPECT_TRUE(isOpened);
    EXPECT_EQ(this->bus().state(), BusState::open);
    this->bus().advance(500ms);
    EXPECT_TRUE(this->isLive());
}

TYPED_TEST(EncoderBusContract, OpensAThousandTimes)
{
    int told = 0;
    QObject::connect(&this->bus(), &EncoderBus::nodesChanged, &this->bus(), [&] { ++told; });
    for (int i = 0; i < 1000; ++i) {
        this->open(i % 2 == 0);
        ASSERT_TRUE(this->isLive());
        this->bus().close();
    }
    EXPECT_GE(told, 1000);
    EXPECT_EQ(this->changes(), 0);
}

class BusesTest : public testing::Test
{
protected:
    BusesTest()
    {
        buses.add(ring.bus);
        buses.add(line.bus);
    }

    void openBoth()
    {
        ASSERT_TRUE(ring.open(EncoderBus::Start::watching));
        ASSERT_TRUE(line.open(EncoderBus::Start::watching));
    }

    Ring ring;
    Line line;
    Buses buses;
};

TEST_F(BusesTest, TheirOrderIsThatOfTheirNumbersWhicheverConnectedFirst)
{
    openBoth();
    const std::vector<Place> places = buses.places();
    EXPECT_TRUE(std::ranges::is_sorted(places, {}, &Place::bus));
    buses.remove(&ring.bus);
    buses.add(ring.bus);
    EXPECT_EQ(buses.places(), places);
    buses.remove(&line.bus);
    buses.add(line.bus);
    EXPECT_EQ(buses.places(), places);
}

TEST_F(BusesTest, AnEncoderIsFoundOnWhateverBusItIs)
{
    EXPECT_TRUE(buses.places().empty()) << "none is open";
    openBoth();
    EXPECT_EQ(buses.busOf(Ring::place), &ring.bus);
    EXPECT_EQ(buses.busOf(Line::place), &line.bus);
    EXPECT_EQ(buses.encoder(Line::place), line.bus.encoder(Line::place));
    EXPECT_EQ(buses.channel(Ring::place), ring.bus.channel(Ring::place));
    EXPECT_EQ(buses.channel(Line::place), nullptr) << "it has no words";
    buses.remove(&line.bus);
    EXPECT_FALSE(buses.isConnected(Line::place));
    EXPECT_TRUE(buses.isConnected(Ring::place));
}

TEST_F(BusesTest, AlarmStopGoesToAll)
{
    openBoth();
    const auto run = [&] {
        ring.bus.advance(Instant(50ms));
        line.bus.advance(50ms);
    };
    ring.bus.setOperate(true);
    line.bus.setOperate(true);
    run();
    EXPECT_TRUE(ring.bus.isOperating());
    EXPECT_TRUE(line.bus.isOperating());
    const WriteParameters job{.values = {{Parameter::steps, 255}}, .previous = {}};
    ASSERT_TRUE(buses.encoder(Ring::place)->start(job));
    ASSERT_TRUE(buses.encoder(Line::place)->start(job));
    buses.alarmStop();
    run();
    EXPECT_FALSE(buses.encoder(Ring::place)->runningJob());
    EXPECT_FALSE(buses.encoder(Line::place)->runningJob());
    EXPECT_EQ(ring.watch.changes + line.watch.changes, 0);
}

} // namespace
} // namespace codewheel
