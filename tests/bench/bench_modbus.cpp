// SPDX-License-Identifier: GPL-3.0-or-later
// How often 64 moving K3 encoders behind a Modbus/TCP gateway are exchanged, compared with a bare client of
// libmodbus that does the same transactions: OUT read back (function 3) and written (16), IN read (4). The
// gateway is a server of libmodbus on this computer; both clients take turns: directly, and through a relay
// that sends each answer in two parts, behind its header.
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/links/faulty_relay.h"
#include "tests/support/modbus_server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <modbus.h>

namespace {

using namespace codewheel;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int encoders = 64;
constexpr int rounds = 10;
constexpr auto roundTime = 500ms;
constexpr auto frame = 33ms; // a window takes 30 snapshots a second

// The encoders turn: their positions are new with each millisecond.
class Gateway
{
public:
    explicit Gateway(bool splitsAnswers)
        : m_relay(splitsAnswers ? std::make_unique<test::FaultyRelay>(server.port(), 1) : nullptr)
        , m_shafts([this](const std::stop_token &stop) {
            for (std::uint16_t position = 0; !stop.stop_requested(); ++position) {
                std::vector<std::uint16_t> words(2 * encoders);
                for (std::size_t i = 1; i < words.size(); i += 2) // high word first
                    words[i] = static_cast<std::uint16_t>(position % 0x4000 + i);
                server.setInput(0, words);
                std::this_thread::sleep_for(1ms);
            }
        })
    {
        if (m_relay)
            m_relay->splitAll();
    }

    int transactions() { return server.requests(3) + server.requests(4) + server.requests(16); }
    int port() const { return m_relay ? m_relay->port() : server.port(); }
    GatewaySettings settings() const
    {
        return {.host = QStringLiteral("127.0.0.1"), .tcpPort = port(), .pollInterval = 0ms, .timeOut = 10s};
    }

    ModbusServer server;

private:
    std::unique_ptr<test::FaultyRelay> m_relay;
    std::jthread m_shafts;
};

struct Rate
{
    int exchanges = 0;
    double seconds = 0;
    int transactions = 0;

    double perSecond() const { return exchanges / seconds; }
};

template <typename Exchange>
Rate measure(Gateway &gateway, Exchange exchange)
{
    Rate rate;
    const int before = gateway.transactions();
    const Clock::time_point begin = Clock::now();
    for (; Clock::now() - begin < roundTime; ++rate.exchanges)
        if (!exchange())
            std::exit((std::fputs("an exchange failed\n", stderr), 1));
    rate.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    rate.transactions = gateway.transactions() - before;
    return rate;
}

// The ring as the program runs it: a driver for each encoder, and a reader that takes the frames. In Operate.
class Ring
{
public:
    Ring(const Gateway &gateway, const DeviceDescription &device)
        : m_link(std::make_unique<ModbusPort>(gateway.settings()), gateway.settings(), test::k3Ring(encoders))
        , m_runner(m_link)
    {
        (void)m_runner.open({});
        std::vector<command::UseRing::Driver> drivers;
        for (int i = 0; i < encoders; ++i)
            drivers.push_back({makeDriver(device), {}});
        m_runner.post(command::UseRing{test::structureOf(test::k3Ring(encoders)), std::vector<Word>(encoders),
                                       std::move(drivers)});
        m_runner.post(command::StartBus{});
        m_runner.post(command::SetOperate{true});
    }

    Rate measured(Gateway &gateway)
    {
        return measure(gateway, [this] {
            m_runner.turn(m_runner.now() + 50ms);
            if (const auto now = Clock::now(); now >= m_nextFrame) {
                m_nextFrame = now + frame;
                m_runner.takeEvents();
                const auto latest = m_runner.takeLatest();
                return latest && latest->connected && latest->state == MasterState::run;
            }
            return true;
        });
    }

private:
    GatewayLink m_link;
    RingRunner m_runner;
    Clock::time_point m_nextFrame{};
};

class BareClient
{
public:
    explicit BareClient(const Gateway &gateway)
        : m_modbus(modbus_new_tcp("127.0.0.1", gateway.port()))
        , m_map(GatewayMap::of(test::structureOf(test::k3Ring(encoders)), gateway.settings()).value())
    {
        modbus_connect(m_modbus);
    }
    ~BareClient()
    {
        modbus_close(m_modbus);
        modbus_free(m_modbus);
    }
    BareClient(const BareClient &) = delete;
    BareClient &operator=(const BareClient &) = delete;

    Rate measured(Gateway &gateway)
    {
        return measure(gateway, [this] { return exchange(); });
    }

private:
    bool exchange()
    {
        const auto all = [this](const std::vector<RegisterBlock> &blocks, auto call,
                                std::uint16_t *registers) {
            return std::ranges::all_of(blocks, [&](const RegisterBlock &block) {
                return call(m_modbus, block.first, block.count, registers + block.first) == block.count;
            });
        };
        return all(m_map.readBackBlocks(), modbus_read_registers, m_out.data()) &&
               all(m_map.outBlocks(), modbus_write_registers, m_out.data()) &&
               all(m_map.inBlocks(), modbus_read_input_registers, m_in.data());
    }

    modbus_t *m_modbus;
    GatewayMap m_map;
    std::vector<std::uint16_t> m_out = std::vector<std::uint16_t>(2 * encoders);
    std::vector<std::uint16_t> m_in = std::vector<std::uint16_t>(2 * encoders);
};

Rate median(std::vector<Rate> rates)
{
    std::ranges::sort(rates, {}, &Rate::perSecond);
    return rates[rates.size() / 2];
}

void print(const char *what, const Rate &rate)
{
    std::printf("%s: %.0f exchanges a second, %.2f transactions each\n", what, rate.perSecond(),
                static_cast<double>(rate.transactions) / rate.exchanges);
}

// Prints the rate of the program as a share of that of libmodbus alone.
void compare(const char *how, bool splitsAnswers, const DeviceDescription &device)
{
    std::vector<Rate> ours;
    std::vector<Rate> bare;
    for (int round = 0; round < rounds; ++round) {
        Gateway gateway(splitsAnswers); // serves one client after the other
        ours.push_back(Ring(gateway, device).measured(gateway));
        bare.push_back(BareClient(gateway).measured(gateway));
    }
    const Rate our = median(ours);
    const Rate its = median(bare);
    std::printf("%s\n", how);
    print("64 moving K3 encoders through the program", our);
    print("the same transactions by libmodbus alone", its);
    std::printf("%.0f %% of the rate of libmodbus alone\n", 100 * our.perSecond() / its.perSecond());
}

} // namespace

int main()
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &device = *catalog.find(u"fraba-ocd-ib");
    compare("each answer at once (aim: 80 %)", false, device);
    compare("each answer in two parts (aim: 90 %)", true, device);
    return 0;
}
