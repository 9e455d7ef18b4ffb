// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of a link to a ring for GatewayLink on a real port, with a server of libmodbus at its other
// end.
#include "kinds/interbus/links/modbus_port.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/support/modbus_server.h"
#include "tests/support/process_data_link_contract.h"
#include "tests/support/pty_pair.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant noRush = 20s;
constexpr int devices = 70; // more than one transaction moves

// A link with its server, which is there as long as the link.
template <typename Server>
class GatewayWithServer final : public ProcessDataLink
{
public:
    explicit GatewayWithServer(GatewaySettings settings)
        : m_link(std::make_unique<ModbusPort>(m_server.reachedBy(settings)), settings, test::k3Ring(devices))
    {}

    Result<RingStructure> open() override { return m_link.open(); }
    void close() override { m_link.close(); }
    Result<std::vector<Word>> readBackOut() override { return m_link.readBackOut(); }
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override
    {
        return m_link.exchange(out, in);
    }
    Instant now() const override { return m_link.now(); }
    void wait(Instant until) override { m_link.wait(until); }
    bool boundsWordsToCycles() const override { return m_link.boundsWordsToCycles(); }
    void interrupt() override { m_link.interrupt(); }

private:
    Server m_server;
    GatewayLink m_link;
};

struct TcpServer
{
    GatewaySettings reachedBy(GatewaySettings &settings) const
    {
        settings.host = QStringLiteral("127.0.0.1");
        settings.tcpPort = server.port();
        settings.timeOut = noRush;
        return settings;
    }
    ModbusServer server{};
};

struct LineServer
{
    GatewaySettings reachedBy(GatewaySettings &settings) const
    {
        settings.transport = GatewaySettings::Transport::rtu;
        settings.serialPort = pty.path();
        settings.timeOut = 200ms; // as long a line must be quiet after an interruption
        settings.retries = 20;
        return settings;
    }
    PtyPair pty{};
    ModbusServer server{pty.descriptor(), 1};
};

template <typename Server>
LinkUnderTest gatewayBy(const char *name, GatewaySettings settings = {})
{
    return {name, [settings] { return std::make_unique<GatewayWithServer<Server>>(settings); }};
}

const GatewaySettings allInOne{.inArea = RegisterArea::holding, .inFirst = 1'000, .writesWithRead = true};

INSTANTIATE_TEST_SUITE_P(GatewayOnModbus, ProcessDataLinkContract,
                         testing::Values(gatewayBy<TcpServer>("TCP"),
                                         gatewayBy<TcpServer>("TCP, function 23", allInOne),
                                         gatewayBy<LineServer>("RTU"),
                                         gatewayBy<LineServer>("RTU, function 23", allInOne)));

} // namespace
} // namespace codewheel
