// SPDX-License-Identifier: GPL-3.0-or-later
// A gateway whose status register has a meaning that is set: what it says of its ring decides what is shown.
#include "bus/bus_outline.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "tests/support/gateway_session.h"
#include "tests/support/passing_port.h"

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr Place toldFraba = "1.0"_ring;
constexpr int statusAt = 8'192;
constexpr int placeAt = 8'193;
constexpr Register ringRuns = 0x00E0;
constexpr Register ringStands = 0x00C0;      // ready, active
constexpr Register busFailed = 0x0084;       // ready, bus
constexpr Register placeAtSegment3 = 0x0300; // 3.0

const GatewaySettings ofCodewheel{
    .statusRegister = statusAt, .runBit = 5, .faultBits = 1 << 2 | 1 << 3 | 1 << 9, .placeRegister = placeAt};

// Adds the two registers to those of the gateway.
class PortWithStatus final : public PassingPort
{
public:
    struct Told
    {
        Register status = ringRuns;
        Register place = 0;
    };

    PortWithStatus(std::unique_ptr<RegisterPort> port, std::shared_ptr<Told> told)
        : PassingPort(std::move(port))
        , m_told(std::move(told))
    {}

    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        if (area != RegisterArea::input || first < statusAt)
            return PassingPort::read(area, first, to);
        to[0] = first == statusAt ? m_told->status : m_told->place;
        return {};
    }

private:
    std::shared_ptr<Told> m_told;
};

class ToldRingBehindGateway : public testing::Test
{
protected:
    void open(EncoderBus::Start start = EncoderBus::Start::operating)
    {
        ASSERT_TRUE(session.bus->open(start));
        session.bus->advance(1s);
    }
    void say(Register status, Register place = 0)
    {
        told->status = status;
        told->place = place;
        session.bus->advance(1s);
    }
    bool isLive() { return session.encoder(toldFraba).freshness().isLive(); }
    std::vector<Fault> faults() const { return session.bus->outline().faults(); }
    DataCheck running() const
    {
        return *findCheck(session.bus->dataChecks(toldFraba.node, {}), DataCheck::Id::running);
    }

    std::shared_ptr<PortWithStatus::Told> told = std::make_shared<PortWithStatus::Told>();
    GatewaySession session{{.settings = ofCodewheel}, [this](std::unique_ptr<RegisterPort> port) {
                               return std::make_unique<PortWithStatus>(std::move(port), told);
                           }};
};

TEST_F(ToldRingBehindGateway, RunsAsFarAsItSays)
{
    open();
    EXPECT_TRUE(isLive());
    EXPECT_TRUE(faults().empty());
    EXPECT_EQ(running().outcome, DataCheck::Outcome::asExpected);
    EXPECT_EQ(session.bus->outline().state().role, Role::running);
}

TEST_F(ToldRingBehindGateway, ThatHasFailedLooksSoEverywhere)
{
    open();
    say(busFailed, placeAtSegment3);
    EXPECT_FALSE(isLive()) << "its last words are old";
    EXPECT_EQ(session.bus->outline().state(), (StateWord{Role::fault, QStringLiteral("ring failed")}));
    EXPECT_EQ(session.bus->outline().state(0).shown.role, Role::inactive);
    ASSERT_EQ(faults().size(), 1u);
    EXPECT_EQ(faults().front().extent, Fault::Extent::standstill);
    EXPECT_EQ(faults().front().node, "3.0"_ring.node);
    EXPECT_TRUE(faults().front().text.contains(QStringLiteral("0084h")));
    EXPECT_EQ(running().outcome, DataCheck::Outcome::differs);
    const Refusal why{RefusalKind::link,
                      GatewayRefusalId::ringFailedAt,
                      {QStringLiteral("0084h"), faultPlaceText({.number = "3.0"_ring.node})}};
    EXPECT_EQ(session.lastRefusal(), why) << "the messages say it once";
    EXPECT_EQ(session.encoder(toldFraba).start(ReadParameters{{Parameter::steps}}).error(), why);
}

TEST_F(ToldRingBehindGateway, ThatStandsStillIsOldAsWell)
{
    open();
    say(ringStands);
    EXPECT_FALSE(isLive());
    EXPECT_EQ(session.bus->outline().state(), (StateWord{Role::fault, QStringLiteral("ring stands still")}));
    EXPECT_EQ(session.lastRefusal()->id, GatewayRefusalId::ringStands);
}

TEST_F(ToldRingBehindGateway, ThatRunsAgainIsLiveAgain)
{
    open();
    say(busFailed);
    say(ringRuns);
    EXPECT_TRUE(isLive());
    EXPECT_TRUE(faults().empty());
    EXPECT_EQ(session.countOf(RingMessageId::ringRunsAgain), 1u);
    EXPECT_EQ(whyOf(session.finish(toldFraba, ReadParameters{{Parameter::steps}})), "");
}

// That is when an encoder is exchanged.
TEST_F(ToldRingBehindGateway, ThatRunsAgainMayHaveOtherEncoders)
{
    open();
    session.finish(toldFraba, ReadParameters{{Parameter::steps}});
    ASSERT_TRUE(session.encoder(toldFraba).known(Parameter::steps));
    int meetings = 0;
    QObject::connect(session.bus.get(), &EncoderBus::meetsAgain, session.bus.get(), [&] { ++meetings; });
    say(busFailed);
    say(ringRuns);
    EXPECT_EQ(meetings, 1);
    EXPECT_FALSE(session.encoder(toldFraba).known(Parameter::steps));
}

TEST_F(ToldRingBehindGateway, ThatStandsGetsNoZeros)
{
    open();
    say(busFailed);
    session.bus->alarmStop();
    session.bus->advance(1s);
    EXPECT_EQ(session.countOf(RingMessageId::zerosBeforeRing), 1u);
    EXPECT_EQ(session.countOf(RingMessageId::zerosReadBack), 0u);
    ASSERT_EQ(faults().size(), 1u);
    EXPECT_TRUE(faults().front().text.contains(QStringLiteral("zeros of the ALARM STOP are in the gateway")));
    say(ringRuns);
    EXPECT_FALSE(session.bus->areZerosBeforeRing());
    EXPECT_EQ(session.countOf(RingMessageId::zerosReadBack), 1u) << "by now they are at the devices";
}

TEST_F(ToldRingBehindGateway, EndsTheJobsThatItInterrupts)
{
    open();
    session.encoder(toldFraba).tell(Parameter::startUpMode, 1);
    std::optional<Outcome> outcome;
    QObject::connect(&session.encoder(toldFraba), &EncoderSession::finished, session.bus.get(),
                     [&](const Outcome &how) { outcome = how; });
    ASSERT_TRUE(session.encoder(toldFraba).start(
        WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}, Pace::byHand));
    session.bus->advance(30ms);
    say(busFailed);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result.error().id, GatewayRefusalId::ringFailed);
    EXPECT_EQ(outcome->leftIn, EncoderState::unknown);
}

// It has failed from the beginning.
TEST_F(ToldRingBehindGateway, ThatWasConnectedAsItStoodIsNeverLive)
{
    told->status = busFailed;
    open(EncoderBus::Start::watching);
    EXPECT_EQ(session.countOf(MessageId::busStarted), 0u) << "it does not run";
    EXPECT_FALSE(isLive());
    EXPECT_EQ(session.lastRefusal()->id, GatewayRefusalId::ringFailed);
}

} // namespace
} // namespace codewheel
