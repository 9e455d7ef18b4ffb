// SPDX-License-Identifier: GPL-3.0-or-later
// The server at one end of a pseudo terminal, its peer at the other.
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/rtu_frame.h"
#include "kinds/interbus/links/modbus_rtu_server.h"
#include "links/serial_port_link.h"
#include "tests/support/offered_ring.h"
#include "tests/support/pty_pair.h"
#include "tests/support/scripted_link.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

namespace codewheel {
namespace {

using test::OfferedRing;
using testing::ElementsAre;

constexpr SerialSettings rtuSettings{.parity = SerialSettings::Parity::even, .stopBits = 1};

QByteArray frameOf(int unit, const ModbusBytes &pdu)
{
    QByteArray bytes;
    for (const std::uint8_t byte : rtuFrame(unit, pdu))
        bytes.append(static_cast<char>(byte));
    return bytes;
}

class ModbusRtuServerTest : public testing::Test
{
protected:
    void SetUp() override
    {
        auto server = ModbusRtuServer::start(std::make_unique<SerialPortLink>(m_pty.path()), rtuSettings,
                                             ServedUnits(m_ring.guests()), 5);
        ASSERT_TRUE(server) << refusalText(server.error()).toStdString();
        m_server = *std::move(server);
    }
    QByteArray ask(int unit, const ModbusBytes &pdu, qsizetype answer)
    {
        m_pty.send(frameOf(unit, pdu));
        return m_pty.receive(answer);
    }
    void expectToServe()
    {
        const QByteArray answer = frameOf(5, {4, 2, 0x00, 0xE0});
        EXPECT_EQ(ask(5, {4, 0x20, 0, 0, 1}, answer.size()), answer);
    }

    Catalog m_catalog = Catalog::builtIn();
    OfferedRing m_ring{std::make_unique<ScriptedLink>(2), m_catalog};
    PtyPair m_pty;
    std::unique_ptr<ModbusRtuServer> m_server;
};

TEST_F(ModbusRtuServerTest, ReadsAndWritesTheRing)
{
    const QByteArray confirmed = frameOf(5, {16, 0, 2, 0, 2});
    EXPECT_EQ(ask(5, {16, 0, 2, 0, 2, 4, 0x12, 0x34, 0x56, 0x78}, confirmed.size()), confirmed);
    EXPECT_THAT(m_ring.guests()->image({}).out, ElementsAre(0U, 0x12345678U));
    const QByteArray read = frameOf(5, {3, 4, 0x12, 0x34, 0x56, 0x78});
    EXPECT_EQ(ask(5, {3, 0, 2, 0, 2}, read.size()), read);
    const ServedClient client = m_server->clients().clients().at(0);
    EXPECT_EQ(client.address, m_pty.path());
    EXPECT_EQ(client.requests, 2U);
    EXPECT_EQ(client.writes, 1U);
}

// The answer to the second is the first that comes.
TEST_F(ModbusRtuServerTest, WhatIsForOtherUnitsIsNotAnswered)
{
    m_pty.send(frameOf(6, {4, 0, 0, 0, 1}));
    expectToServe();
    EXPECT_EQ(m_server->clients().total().requests, 1U);
}

TEST_F(ModbusRtuServerTest, ABroadcastIsCarriedOutAndNotAnswered)
{
    m_pty.send(frameOf(0, {6, 0, 1, 0x00, 0x77}));
    expectToServe();
    EXPECT_THAT(m_ring.guests()->image({}).out, ElementsAre(0x77U, 0U));
}

TEST_F(ModbusRtuServerTest, AnUnknownFunctionIsRefused)
{
    const QByteArray refused = frameOf(5, {0xAB, 1});
    EXPECT_EQ(ask(5, {0x2B, 0x0E, 1, 0}, refused.size()), refused);
    expectToServe();
}

// A client that gets no answer tries again, after a while.
TEST_F(ModbusRtuServerTest, AfterGarbageAndHalfARequestItUnderstandsTheNext)
{
    for (const QByteArray &garbage : {QByteArray(40, 'U'), frameOf(5, {4, 0x20, 0, 0, 1}).first(4),
                                      QByteArray(700, '\xFF'), QByteArray(1, '\x05')}) {
        m_pty.send(garbage);
        QByteArray answer;
        const QByteArray wanted = frameOf(5, {4, 2, 0x00, 0xE0});
        for (int tries = 0; tries < 50 && answer.isEmpty(); ++tries) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50)); // silence is what is tested
            m_pty.send(frameOf(5, {4, 0x20, 0, 0, 1}));
            pollfd waited{m_pty.descriptor(), POLLIN, 0};
            if (::poll(&waited, 1, 200) == 1)
                answer = m_pty.receive(wanted.size());
        }
        EXPECT_EQ(answer.left(wanted.size()), wanted); // a slow server answers an earlier try too
    }
}

TEST_F(ModbusRtuServerTest, AnAdapterThatIsUnpluggedIsTold)
{
    EXPECT_FALSE(m_server->whyEnded());
    m_pty.unplug();
    EXPECT_TRUE(m_ring.waitFor([&] { return m_server->whyEnded().has_value(); }));
    EXPECT_EQ(m_server->whyEnded()->id, RefusalId::portLost);
}

TEST_F(ModbusRtuServerTest, APortThatIsNotThereIsRefused)
{
    const auto server =
        ModbusRtuServer::start(std::make_unique<SerialPortLink>(QStringLiteral("/dev/there-is-none")),
                               rtuSettings, ServedUnits(m_ring.guests()), 1);
    ASSERT_FALSE(server);
    EXPECT_EQ(server.error().id, RefusalId::portNotFound);
}

} // namespace
} // namespace codewheel
