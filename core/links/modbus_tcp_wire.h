// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/connect_to_host.h"
#include "links/modbus_library.h"
#include "links/modbus_wire.h"
#include "modbus/gateway_settings.h"

namespace codewheel {

// A connection to a gateway (MODBUS Messaging on TCP/IP Implementation Guide V1.0b).
//
// Answers are told apart by their transaction. After silence the connection stays: a late answer has the
// number of a transaction that is over and is dropped, while connecting anew would lose nothing but time, and
// many gateways have room for few connections and give up an old one slowly. After a damaged or foreign
// answer nobody knows where the next one begins; then the wire connects anew before the next request.
//
// What libmodbus does not check is checked here and by modbus_message::take(). Its version 3.1.6 takes an
// answer of another unit, one whose header has another length or protocol, and one about a write to other
// registers.
class ModbusTcpWire final : public ModbusWire
{
public:
    ModbusTcpWire(const GatewaySettings &settings, WakeFlag &wake);

    Result<void> open() override;
    void close() override;
    tl::expected<modbus_message::Message, RegisterError>
    exchange(const modbus_message::Message &request) override;
    void distrust() override { m_isOutOfStep = true; }

private:
    using Time = std::chrono::steady_clock::time_point;
    using Failed = tl::unexpected<RegisterError>;

    Result<void> connect(Instant timeOut);
    RegisterPort::Done send(const modbus_message::Message &request);
    tl::expected<modbus_message::Message, RegisterError> receive(Time until);
    tl::expected<std::size_t, RegisterError> waitForAnswer(Time until);
    void wakeAt(std::size_t bytes);
    bool isOver(std::uint16_t transaction) const;
    Failed failed(RegisterError error);
    Failed outOfStep(const QString &text);

    const GatewaySettings m_settings;
    WakeFlag &m_wake;
    std::vector<SocketAddress> m_addresses;
    bool m_isOpen = false;
    Modbus m_modbus; // null: to be connected anew
    bool m_isOutOfStep = false;
    std::uint16_t m_transaction = 0; // the last one
    int m_before = -1;               // transactions before it on this connection
    std::size_t m_wakesAt = 1;       // bytes that have come
};

} // namespace codewheel
