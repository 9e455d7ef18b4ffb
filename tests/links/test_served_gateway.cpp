// SPDX-License-Identifier: GPL-3.0-or-later
// Two sessions, as in two programs: one has a ring and offers it, the other reaches it as a gateway.
#include "bus/bus_outline.h"
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/links/modbus_tcp_server.h"
#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "kinds/interbus/words/device_number.h"
#include "kinds/interbus/words/profiles.h"
#include "tests/support/offered_ring.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::OfferedRing;

class ServedGateway : public testing::Test
{
protected:
    void SetUp() override
    {
        auto ring = std::make_shared<SimulatedRing>();
        for (int segment = 1; segment <= 3; ++segment) {
            const RingDevice device{DeviceNumber{segment, 0}.node(), 0x0237, 2, 2,
                                    QStringLiteral("fraba-ocd-ib")};
            auto encoder = std::make_unique<FrabaK3>(PhysicalResolution{}, 1'000 * segment, FrabaPlate{});
            m_encoders.push_back(encoder.get());
            ring->add(device, std::move(encoder));
            m_planned.push_back({device, profile::k3});
        }
        m_controls = ring;
        m_ring = std::make_unique<OfferedRing>(std::make_unique<SimulatedRingLink>(ring), m_catalog);
        auto server = ModbusTcpServer::start({}, ServedUnits(m_ring->guests()));
        ASSERT_TRUE(server) << refusalText(server.error()).toStdString();
        m_server = *std::move(server);
    }
    // The other program connects.
    void connect(GatewaySettings settings = {})
    {
        settings.host = QStringLiteral("127.0.0.1");
        settings.tcpPort = m_server->place().port;
        settings.timeOut = 20s;
        m_other = std::make_unique<RingSession>(
            std::make_unique<GatewayLink>(std::make_unique<ModbusPort>(settings), settings, m_planned),
            m_catalog, QDateTime::currentDateTime());
        ASSERT_TRUE(m_other->open(EncoderBus::Start::watching, Pacing{1ms}));
        ASSERT_TRUE(waitFor([this] { return m_other->isOpen() && m_other->isRunning(); }));
        ASSERT_TRUE(waitFor([this] { return encoder(1)->latest().state == EncoderState::operation; }));
    }
    template <typename Condition>
    bool waitFor(Condition condition)
    {
        return m_ring->waitFor([&] {
            if (m_other)
                m_other->pump();
            return condition();
        });
    }
    EncoderSession *encoder(int segment)
    {
        return m_other->encoder(m_other->placeOf(DeviceNumber{segment, 0}.node()));
    }
    // The outcome of a job of the other program.
    Result<void> carryOut(int segment, const Job &job)
    {
        std::optional<Outcome> ended;
        const auto connection =
            QObject::connect(encoder(segment), &EncoderSession::finished, encoder(segment),
                             [&](const Outcome &outcome) { ended = outcome; });
        Result<void> result = encoder(segment)->start(job).map([](JobId) {});
        if (result) {
            EXPECT_TRUE(waitFor([&] { return ended.has_value(); }));
            result = ended ? ended->result : result;
        }
        QObject::disconnect(connection);
        return result;
    }

    // What an encoder has at the end, when no cycle changes it any more.
    const FrabaK3 &atTheEnd(int segment)
    {
        m_ring->bus().close();
        return *m_encoders.at(static_cast<std::size_t>(segment) - 1);
    }

    Catalog m_catalog = Catalog::builtIn();
    std::vector<FrabaK3 *> m_encoders;
    std::shared_ptr<TrainingControls> m_controls;
    std::vector<GatewayDevice> m_planned;
    std::unique_ptr<OfferedRing> m_ring;
    std::unique_ptr<ModbusTcpServer> m_server;
    std::unique_ptr<RingSession> m_other;
};

TEST_F(ServedGateway, TheOtherProgramShowsThePositions)
{
    connect();
    EXPECT_TRUE(waitFor([this] { return (encoder(2)->latest().in & 0x1FFFFFF) != 0; }));
    EXPECT_EQ(encoder(2)->latest().in, m_ring->guests()->image({}).in[1]);
    EXPECT_EQ(m_server->clients().total().writes, 0U) << "connecting and watching write nothing";
}

TEST_F(ServedGateway, AnEncoderIsParameterizedFromTheOtherProgram)
{
    connect();
    WriteParameters job;
    job.values = {{Parameter::steps, 255}, {Parameter::revolutions, 16}, {Parameter::preset, 100}};
    EXPECT_FALSE(carryOut(2, job)) << "in Watch";
    m_other->setOperate(true);
    ASSERT_TRUE(waitFor([this] { return m_other->isOperating(); }));
    const auto written = carryOut(2, job);
    ASSERT_TRUE(written) << refusalText(written.error()).toStdString();
    EXPECT_TRUE(waitFor([this] { return encoder(2)->latest().state == EncoderState::operation; }));
    EXPECT_EQ(atTheEnd(2).parameters().steps, 255);
    EXPECT_EQ(atTheEnd(2).parameters().revolutions, 16);
    EXPECT_EQ(atTheEnd(2).parameters().preset, 100);
    EXPECT_GE(atTheEnd(2).eepromWrites(), 1);
    EXPECT_EQ(atTheEnd(1).eepromWrites() + atTheEnd(3).eepromWrites(), 0);
}

TEST_F(ServedGateway, ItIsDoneWithFunction23Too)
{
    GatewaySettings settings;
    settings.inArea = RegisterArea::holding;
    settings.inFirst = served_registers::inAsHolding;
    settings.writesWithRead = true;
    connect(settings);
    m_other->setOperate(true);
    ASSERT_TRUE(waitFor([this] { return m_other->isOperating(); }));
    WriteParameters job;
    job.values = {{Parameter::steps, 100}};
    const auto written = carryOut(1, job);
    ASSERT_TRUE(written) << refusalText(written.error()).toStdString();
    EXPECT_EQ(atTheEnd(1).parameters().steps, 100);
}

// The trainer's side is as with words written by hand: its user sees each in the trace, and in the account.
TEST_F(ServedGateway, TheProgramThatOffersTheRingSeesWhatIsDone)
{
    EncoderSession *offered = m_ring->bus().encoder(m_ring->bus().placeOf(NodeId("2.0")));
    ASSERT_NE(offered, nullptr);
    int rows = 0;
    int words = 0;
    QObject::connect(offered, &EncoderSession::exchanged, offered, [&](const Exchange &) { ++rows; });
    QObject::connect(offered, &EncoderSession::wordAboutToBeSent, offered, [&](Word) { ++words; });
    connect();
    m_other->setOperate(true);
    ASSERT_TRUE(waitFor([this] { return m_other->isOperating(); }));
    WriteParameters job;
    job.values = {{Parameter::steps, 255}};
    ASSERT_TRUE(carryOut(2, job));
    EXPECT_TRUE(waitFor([&] { return words >= 3; })) << "start, steps, run";
    EXPECT_GE(rows, words);
}

TEST_F(ServedGateway, AStoppedRingEndsWhatTheOtherProgramDoes)
{
    connect();
    m_other->setOperate(true);
    ASSERT_TRUE(waitFor([this] { return m_other->isOperating(); }));
    m_ring->bus().setOperate(false);
    ASSERT_TRUE(waitFor([this] { return !m_ring->bus().isOperating(); }));
    WriteParameters job;
    job.values = {{Parameter::steps, 255}};
    EXPECT_FALSE(carryOut(1, job));
    EXPECT_EQ(atTheEnd(1).eepromWrites(), 0);
}

// The test of the other program recognises the registers, and then a failed ring looks so there.
TEST_F(ServedGateway, ARingThatFailsIsToldToTheOtherProgram)
{
    GatewaySettings settings{
        .host = QStringLiteral("127.0.0.1"), .tcpPort = m_server->place().port, .timeOut = 20s};
    std::vector<CheckedDevice> devices;
    for (const GatewayDevice &device : m_planned)
        devices.push_back({device.participant, {*m_catalog.find(u"fraba-ocd-ib"), {}}});
    {
        ModbusPort port(settings);
        GatewayCheck check(port, settings, devices);
        std::map<QString, QString> proposed;
        while (!check.isDone())
            proposed.merge(check.next().proposed);
        const std::map<QString, QString> expected{{QStringLiteral("status"), QStringLiteral("8192")},
                                                  {QStringLiteral("run-bit"), QStringLiteral("5")},
                                                  {QStringLiteral("fault-bits"), QStringLiteral("2+3+9")},
                                                  {QStringLiteral("place"), QStringLiteral("8193")}};
        EXPECT_EQ(proposed, expected);
        ASSERT_TRUE(applySettings(settings, proposed));
    }
    connect(settings);
    EXPECT_TRUE(encoder(1)->freshness().isLive());
    m_ring->bus().pump();
    m_controls->setFault(TrainingFault::wireBreak, DeviceNumber{3, 0}.node(), 1);
    ASSERT_TRUE(waitFor([this] { return !encoder(1)->freshness().isLive(); }));
    EXPECT_TRUE(waitFor([this] { return m_other->outline().state().role == Role::fault; }));
    const std::vector<Fault> faults = m_other->outline().faults();
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults.front().extent, Fault::Extent::standstill);
    EXPECT_EQ(encoder(1)->start(ReadParameters{{Parameter::steps}}).error().kind, RefusalKind::link);
}

} // namespace
} // namespace codewheel
