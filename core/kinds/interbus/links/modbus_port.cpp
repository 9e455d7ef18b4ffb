// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_port.h"

#include "kinds/interbus/links/modbus_rtu_wire.h"
#include "kinds/interbus/links/modbus_tcp_wire.h"

namespace codewheel {
namespace {

constexpr int readHoldingFunction = 3;
constexpr int readInputFunction = 4;

std::unique_ptr<ModbusWire> wireFor(const GatewaySettings &settings)
{
    if (settings.transport == GatewaySettings::Transport::tcp)
        return std::make_unique<ModbusTcpWire>(settings);
    return std::make_unique<ModbusRtuWire>(settings);
}

} // namespace

ModbusPort::ModbusPort(const GatewaySettings &settings)
    : m_settings(settings)
    , m_wire(wireFor(settings))
{}

RegisterPort::Done ModbusPort::transact(const modbus_message::Pdu &request, std::span<Register> to)
{
    const auto answer = m_wire->exchange(request);
    if (!answer)
        return tl::unexpected(answer.error());
    auto done = modbus_message::take(request, *answer, to);
    if (!done && done.error().kind == RegisterError::Kind::wrongAnswer)
        m_wire->distrust();
    return done;
}

RegisterPort::Done ModbusPort::read(RegisterArea area, int first, std::span<Register> to)
{
    const int function = area == RegisterArea::input ? readInputFunction : readHoldingFunction;
    return transact(modbus_message::read(function, first, to.size()), to);
}

RegisterPort::Done ModbusPort::write(int first, std::span<const Register> from)
{
    return transact(modbus_message::write(first, from), {});
}

RegisterPort::Done ModbusPort::writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                                            std::span<Register> to)
{
    return transact(modbus_message::writeAndRead(writeFirst, from, readFirst, to.size()), to);
}

QString ModbusPort::name() const
{
    return gatewayUnit(m_settings);
}

} // namespace codewheel
