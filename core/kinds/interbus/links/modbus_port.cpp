// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_port.h"

#include "kinds/interbus/links/modbus_rtu_wire.h"
#include "kinds/interbus/links/modbus_tcp_wire.h"

namespace codewheel {

namespace {

constexpr int readHoldingFunction = 3;
constexpr int readInputFunction = 4;

} // namespace

struct ModbusPort::Private
{
    explicit Private(const GatewaySettings &all)
        : settings(all)
    {
        if (settings.transport == GatewaySettings::Transport::tcp)
            wire = std::make_unique<ModbusTcpWire>(settings);
        else
            wire = std::make_unique<ModbusRtuWire>(settings);
    }

    Done transact(const modbus_message::Pdu &request, std::span<Register> to)
    {
        const auto answer = wire->exchange(request);
        if (!answer)
            return tl::unexpected(answer.error());
        auto done = modbus_message::take(request, *answer, to);
        if (!done && done.error().kind == RegisterError::Kind::wrongAnswer)
            wire->distrust();
        return done;
    }

    const GatewaySettings settings;
    std::unique_ptr<ModbusWire> wire;
};

ModbusPort::ModbusPort(const GatewaySettings &settings)
    : d(std::make_unique<Private>(settings))
{}

ModbusPort::~ModbusPort() = default;

Result<void> ModbusPort::open()
{
    return d->wire->open();
}

void ModbusPort::close()
{
    d->wire->close();
}

RegisterPort::Done ModbusPort::read(RegisterArea area, int first, std::span<Register> to)
{
    const int function = area == RegisterArea::input ? readInputFunction : readHoldingFunction;
    return d->transact(modbus_message::read(function, first, to.size()), to);
}

RegisterPort::Done ModbusPort::write(int first, std::span<const Register> from)
{
    return d->transact(modbus_message::write(first, from), {});
}

RegisterPort::Done ModbusPort::writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                                            std::span<Register> to)
{
    return d->transact(modbus_message::writeAndRead(writeFirst, from, readFirst, to.size()), to);
}

Instant ModbusPort::now() const
{
    return d->wire->now();
}

void ModbusPort::wait(Instant until)
{
    d->wire->wait(until);
}

void ModbusPort::interrupt()
{
    d->wire->interrupt();
}

RegisterPort::Noticed ModbusPort::noticed() const
{
    return d->wire->noticed();
}

QString ModbusPort::name() const
{
    return gatewayUnit(d->settings);
}

} // namespace codewheel
