// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/links/modbus_wire.h"

#include <memory>

namespace codewheel {

// The registers of a gateway, over TCP or a serial line.
class ModbusPort final : public RegisterPort
{
public:
    explicit ModbusPort(const GatewaySettings &settings);

    Result<void> open() override { return m_wire->open(); }
    void close() override { m_wire->close(); }
    Done read(RegisterArea area, int first, std::span<Register> to) override;
    Done write(int first, std::span<const Register> from) override;
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override;
    Instant now() const override { return m_wire->now(); }
    void wait(Instant until) override { m_wire->wait(until); }
    void interrupt() override { m_wire->interrupt(); }
    QString name() const override;
    Noticed noticed() const override { return m_wire->noticed(); }

private:
    Done transact(const modbus_message::Pdu &request, std::span<Register> to);

    const GatewaySettings m_settings;
    const std::unique_ptr<ModbusWire> m_wire;
};

} // namespace codewheel
