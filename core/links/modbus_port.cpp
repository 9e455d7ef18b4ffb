// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/modbus_port.h"

#include "links/modbus_rtu_wire.h"
#include "links/modbus_tcp_wire.h"
#include "links/wait_for.h"

namespace codewheel {

using std::chrono::steady_clock;

struct ModbusPort::Private
{
    explicit Private(const GatewaySettings &all)
        : settings(all)
    {
        if (settings.transport == GatewaySettings::Transport::tcp)
            wire = std::make_unique<ModbusTcpWire>(settings, wake);
        else
            wire = std::make_unique<ModbusRtuWire>(settings, wake);
    }

    Done transact(const modbus_message::Message &request, std::span<Register> to)
    {
        if (wake.lower())
            return tl::unexpected(registerError(RegisterError::Kind::stopped));
        const auto answer = wire->exchange(request);
        if (!answer)
            return tl::unexpected(answer.error());
        auto done = modbus_message::take(request, *answer, to);
        if (!done && done.error().kind == RegisterError::Kind::wrongAnswer)
            wire->distrust();
        return done;
    }

    const GatewaySettings settings;
    WakeFlag wake;
    std::unique_ptr<ModbusWire> wire;
    const steady_clock::time_point begin = steady_clock::now();
};

ModbusPort::ModbusPort(const GatewaySettings &settings)
    : d(std::make_unique<Private>(settings))
{}

ModbusPort::~ModbusPort() = default;

Result<void> ModbusPort::open()
{
    if (d->wake.lower()) {
        close();
        return refuse(RefusalKind::stopped, RefusalId::cancelled);
    }
    return d->wire->open();
}

void ModbusPort::close()
{
    d->wire->close();
}

RegisterPort::Done ModbusPort::read(RegisterArea area, int first, std::span<Register> to)
{
    const int function =
        area == RegisterArea::input ? MODBUS_FC_READ_INPUT_REGISTERS : MODBUS_FC_READ_HOLDING_REGISTERS;
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
    return std::chrono::duration_cast<Instant>(steady_clock::now() - d->begin);
}

void ModbusPort::wait(Instant until)
{
    waitFor(-1, 0, d->wake, d->begin + until);
}

void ModbusPort::interrupt()
{
    d->wake.raise();
}

QString ModbusPort::name() const
{
    return gatewayUnit(d->settings);
}

} // namespace codewheel
