// SPDX-License-Identifier: GPL-3.0-or-later
// The port against a server of libmodbus, over TCP and over a pseudo terminal.
#include "kinds/interbus/links/modbus_port.h"
#include "tests/support/modbus_server.h"
#include "tests/support/pty_pair.h"

#include <gtest/gtest.h>
#include <numeric>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using Registers = std::vector<Register>;

constexpr Instant patience = 10s; // for answers that come

struct OverTcp
{
    ModbusServer server{};
    GatewaySettings settings{
        .host = QStringLiteral("127.0.0.1"), .tcpPort = server.port(), .timeOut = patience};
};

struct OverLine
{
    PtyPair pty{};
    ModbusServer server{pty.descriptor(), 17};
    GatewaySettings settings{.transport = GatewaySettings::Transport::rtu,
                             .serialPort = pty.path(),
                             .unit = 17,
                             .timeOut = patience};
};

template <typename Way>
class ModbusPortOn : public testing::Test
{
protected:
    Way m_way;
    ModbusPort m_port{m_way.settings};
};

using Ways = testing::Types<OverTcp, OverLine>;
TYPED_TEST_SUITE(ModbusPortOn, Ways);

Registers counted(std::size_t count, Register from)
{
    Registers registers(count);
    std::iota(registers.begin(), registers.end(), from);
    return registers;
}

TYPED_TEST(ModbusPortOn, ReadsAndWritesAsManyRegistersAsTheProtocolAllows)
{
    ModbusPort &port = this->m_port;
    ModbusServer &server = this->m_way.server;
    server.setInput(65'411, counted(125, 0x1234));
    server.setHolding(7, counted(125, 0x4321));
    ASSERT_TRUE(port.open());
    Registers read(125);
    EXPECT_TRUE(port.read(RegisterArea::input, 65'411, read));
    EXPECT_EQ(read, counted(125, 0x1234));
    EXPECT_TRUE(port.read(RegisterArea::holding, 7, read));
    EXPECT_EQ(read, counted(125, 0x4321));
    EXPECT_TRUE(port.write(300, counted(123, 0xFF00)));
    EXPECT_EQ(server.holding(300, 123), counted(123, 0xFF00));
    Registers one(1);
    EXPECT_TRUE(port.writeAndRead(1'000, counted(121, 0x0102), 1'000, one));
    EXPECT_EQ(server.holding(1'000, 121), counted(121, 0x0102));
    EXPECT_EQ(one, Registers{0x0102});
}

TYPED_TEST(ModbusPortOn, ExceptionsHaveTheirCodeAndTheNextRequestIsAnswered)
{
    ModbusPort &port = this->m_port;
    ASSERT_TRUE(port.open());
    Registers read(2);
    const auto refused = port.read(RegisterArea::input, 65'535, read); // its second register is none
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(), (RegisterError{RegisterError::Kind::exception, 2, {}}));
    EXPECT_TRUE(port.read(RegisterArea::input, 65'534, read));
}

TYPED_TEST(ModbusPortOn, AClosedPortIsClosedAndOpensAgain)
{
    ModbusPort &port = this->m_port;
    Registers read(1);
    EXPECT_EQ(port.read(RegisterArea::input, 0, read).error().kind, RegisterError::Kind::closed);
    ASSERT_TRUE(port.open());
    ASSERT_TRUE(port.open()); // anew
    EXPECT_TRUE(port.read(RegisterArea::input, 0, read));
    port.close();
    EXPECT_EQ(port.write(0, read).error().kind, RegisterError::Kind::closed);
    ASSERT_TRUE(port.open());
    EXPECT_TRUE(port.write(0, read));
}

TYPED_TEST(ModbusPortOn, OpeningSendsNothing)
{
    ASSERT_TRUE(this->m_port.open());
    Registers read(1);
    ASSERT_TRUE(this->m_port.read(RegisterArea::input, 0, read));
    int requests = 0;
    for (int function = 0; function < 256; ++function)
        requests += this->m_way.server.requests(function);
    EXPECT_EQ(requests, 1);
}

} // namespace
} // namespace codewheel
