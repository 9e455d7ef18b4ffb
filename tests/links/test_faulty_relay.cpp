// SPDX-License-Identifier: GPL-3.0-or-later
// A minute on a bad network, in real time: a gateway link on a real port, with libmodbus at the other end.
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/links/modbus_port.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/links/faulty_relay.h"
#include "tests/support/modbus_server.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::FaultyRelay;

constexpr int relayedEncoders = 70; // more than one transaction moves
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr auto relayedFor = 10s;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr auto relayedFor = 10s;
#else
constexpr auto relayedFor = 60s;
#endif
#else
constexpr auto relayedFor = 60s;
#endif

// The words of a device say whose they are, and their halves belong together.
Word markedWord(std::size_t device, unsigned round)
{
    const Word high = static_cast<Word>(device + 1) << 8 | (round & 0xFF);
    return high << 16 | (high ^ 0xFFFF);
}
bool isOf(std::size_t device, Word word)
{
    const Word high = word >> 16;
    return (high >> 8) == device + 1 && (word & 0xFFFF) == (high ^ 0xFFFF);
}
std::vector<std::uint16_t> registersOfRound(unsigned round)
{
    std::vector<std::uint16_t> registers;
    for (std::size_t i = 0; i < relayedEncoders; ++i) {
        registers.push_back(static_cast<std::uint16_t>(markedWord(i, round) >> 16));
        registers.push_back(static_cast<std::uint16_t>(markedWord(i, round) & 0xFFFF));
    }
    return registers;
}

class BadNetwork : public testing::Test
{
protected:
    BadNetwork()
        : relay(server.port(), 7)
    {
        GatewaySettings settings;
        settings.host = QStringLiteral("127.0.0.1");
        settings.tcpPort = relay.port();
        settings.timeOut = 150ms;
        std::vector<GatewayDevice> ring = test::k3Ring(relayedEncoders);
        for (GatewayDevice &device : ring)
            device.profile.reset(); // no word is a moving position
        link = std::make_unique<GatewayLink>(std::make_unique<ModbusPort>(settings), settings, ring);
        server.setInput(0, registersOfRound(0));
    }
    std::vector<Word> wordsThere()
    {
        const auto registers = server.holding(0, 2 * relayedEncoders);
        std::vector<Word> words;
        for (std::size_t i = 0; i + 1 < registers.size(); i += 2)
            words.push_back(Word{registers[i]} << 16 | registers[i + 1]);
        return words;
    }
    void reconnect()
    {
        const auto opened = link->open();
        ++(opened ? connections : refused);
        if (!opened)
            return;
        const auto back = link->readBackOut();
        isOpen = back.has_value();
        if (back) {
            EXPECT_EQ(*back, wordsThere());
        }
    }
    // OUT of each device is what was asked for now, or before.
    void exchange()
    {
        ++round;
        server.setInput(0, registersOfRound(round));
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = markedWord(i, round);
        const auto exchanged = link->exchange(out, in);
        isOpen = exchanged.has_value();
        if (!exchanged) {
            EXPECT_NE(exchanged.error().id, GatewayRefusalId::outNotOurs) << "nobody else writes";
        }
        for (std::size_t i = 0; i < in.size(); ++i) {
            EXPECT_TRUE(!link->age(i) || isOf(i, in[i])) << i << ' ' << std::hex << in[i];
        }
        const std::vector<Word> there = wordsThere();
        for (std::size_t i = 0; i < there.size(); ++i) {
            EXPECT_TRUE(there[i] == 0 || isOf(i, there[i])) << i << ' ' << std::hex << there[i];
            EXPECT_TRUE(!exchanged || there[i] == out[i]) << i << ' ' << std::hex << there[i];
        }
        exchanges += exchanged ? 1 : 0;
    }

    ModbusServer server;
    FaultyRelay relay;
    std::unique_ptr<GatewayLink> link;
    std::vector<Word> in = std::vector<Word>(relayedEncoders);
    std::vector<Word> out = std::vector<Word>(relayedEncoders);
    unsigned round = 0;
    bool isOpen = false;
    int exchanges = 0;
    int connections = 0;
    int refused = 0;
};

TEST_F(BadNetwork, PutsNoWordWhereItDoesNotBelong)
{
    const auto end = std::chrono::steady_clock::now() + relayedFor;
    for (int i = 0; std::chrono::steady_clock::now() < end && !HasFailure(); ++i) {
        relay.make(i % 200 < 100 ? 5 : 20);
        if (isOpen)
            exchange();
        else
            reconnect();
    }
    for (int kind = 0; kind < FaultyRelay::kinds; ++kind)
        EXPECT_GT(relay.made(static_cast<FaultyRelay::Kind>(kind)), 0) << kind;
    EXPECT_GT(exchanges, 0);
    EXPECT_GT(connections, 1);

    relay.make(0);
    const int before = exchanges;
    for (int i = 0; i < 100 && exchanges < before + 10; ++i)
        isOpen ? exchange() : reconnect();
    EXPECT_GE(exchanges, before + 10) << "everything works again";
    std::cout << exchanges << " exchanges, " << connections << " connections, " << refused << " refused\n";
}

} // namespace
} // namespace codewheel
