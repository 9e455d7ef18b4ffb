// SPDX-License-Identifier: GPL-3.0-or-later
// What every bus keeps (bus/encoder_bus.h), on its simulator and in virtual time.
#include "bus/buses.h"
#include "catalog/catalog.h"
#include "drivers/esc_driver.h"
#include "line/line_session.h"
#include "ring/bus_session.h"
#include "simulator/simulated_line_link.h"
#include "simulator/training_bus.h"
#include "tests/bus/watched_links.h"
#include "tests/support/places.h"

#include <algorithm>
#include <gtest/gtest.h>

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
    static constexpr std::int64_t steps = 255;

    void open(bool operating)
    {
        ASSERT_TRUE(bus.open(operating ? BusSession::Start::operating : BusSession::Start::watching));
        bus.encoder(place)->tell(Parameter::startUpMode, 1); // position mode
    }

    int changes = 0; // that went out
    BusSession bus{std::make_unique<test::WatchedRingLink>(makeTrainingBus(catalog()).link, changes),
                   catalog(), began};
};

struct Line
{
    static constexpr Place place = placeOnLine({5});
    static constexpr std::int64_t steps = 864;

    void open(bool operating)
    {
        ASSERT_TRUE(bus.open({}, {}, operating ? LineSession::Start::operating : LineSession::Start::watching,
                             LineSession::Drive::byHand));
        ASSERT_TRUE(bus.add({5}, QStringLiteral("kuebler-esc-rs485")));
    }

    int changes = 0; // that went out
    LineSession bus{std::make_unique<test::WatchedLineLink>(
                        std::make_unique<SimulatedLineLink>(std::make_shared<SimulatedLine>()), changes),
                    catalog(), began, [](const DeviceDescription &device, LineAddress address) {
                        return std::make_unique<EscDriver>(device, address);
                    }};
};

template <class Kind>
class EncoderBusContract : public testing::Test
{
protected:
    EncoderBus &bus() { return m_kind.bus; }
    EncoderSession &encoder() { return *bus().encoder(Kind::place); }
    int changes() const { return m_kind.changes; }

    void open(bool operating)
    {
        m_outcome.reset();
        m_kind.open(operating);
        bus().advance(100ms);
        QObject::connect(&encoder(), &EncoderSession::finished, &bus(),
                         [this](const Outcome &outcome) { m_outcome = outcome; });
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
    RefusalId whyItEnded() const
    {
        return m_outcome->result ? RefusalId::nothingToDo : m_outcome->result.error().id;
    }

    std::optional<Outcome> m_outcome;

private:
    Kind m_kind;
};

using Kinds = testing::Types<Ring, Line>;
TYPED_TEST_SUITE(EncoderBusContract, Kinds);

TYPED_TEST(EncoderBusContract, WatchSendsNothingThatChangesAnything)
{
    this->open(false);
    EXPECT_TRUE(this->bus().isOpen());
    EXPECT_TRUE(this->bus().isRunning());
    EXPECT_TRUE(this->bus().isSimulated());
    EXPECT_FALSE(this->bus().isOperating());
    EXPECT_EQ(this->start().error().id, RefusalId::watchOnly);
    this->bus().advance(1s);
    EXPECT_EQ(this->changes(), 0);
    EXPECT_TRUE(this->encoder().freshness().isLive());
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
    this->open(false);
    this->bus().setRunning(false);
    this->bus().advance(50ms);
    EXPECT_FALSE(this->bus().isRunning());
    EXPECT_EQ(this->encoder().freshness().reason(), Freshness::Reason::stopped);
    this->bus().setRunning(true);
    this->bus().advance(50ms);
    EXPECT_TRUE(this->encoder().freshness().isLive());
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

TYPED_TEST(EncoderBusContract, OpensAThousandTimes)
{
    int told = 0;
    QObject::connect(&this->bus(), &EncoderBus::nodesChanged, &this->bus(), [&] { ++told; });
    for (int i = 0; i < 1000; ++i) {
        this->open(i % 2 == 0);
        ASSERT_TRUE(this->encoder().freshness().isLive());
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

    Ring ring;
    Line line;
    Buses buses;
};

TEST_F(BusesTest, AnEncoderIsFoundOnWhateverBusItIs)
{
    EXPECT_TRUE(buses.places().empty()) << "none is open";
    ring.open(false);
    line.open(false);
    EXPECT_EQ(buses.busOf(Ring::place), &ring.bus);
    EXPECT_EQ(buses.busOf(Line::place), &line.bus);
    EXPECT_EQ(buses.encoder(Line::place), line.bus.encoder(Line::place));
    EXPECT_EQ(buses.channel(Ring::place), ring.bus.channel(Ring::place));
    EXPECT_EQ(buses.channel(Line::place), nullptr) << "it has no words";
    buses.remove(&line.bus);
    EXPECT_FALSE(buses.isConnected(Line::place));
    EXPECT_TRUE(buses.isConnected(Ring::place));
}

TEST_F(BusesTest, OperateAndAlarmStopGoToAll)
{
    ring.open(false);
    line.open(false);
    const auto run = [&] {
        ring.bus.advance(Instant(50ms));
        line.bus.advance(50ms);
    };
    buses.setOperate(true);
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
    EXPECT_EQ(ring.changes + line.changes, 0);
}

} // namespace
} // namespace codewheel
