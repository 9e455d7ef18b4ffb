// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/modbus_port.h"

#include "links/wake_flag.h"

#include <chrono>
#include <poll.h>

namespace codewheel {

struct ModbusPort::Private
{
    GatewaySettings settings;
    WakeFlag wake{};
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
};

ModbusPort::ModbusPort(const GatewaySettings &settings)
    : d(new Private{settings})
{}

ModbusPort::~ModbusPort() = default;

Result<void> ModbusPort::open()
{
    return refuse(RefusalKind::link, RefusalId::linkFailed, {QStringLiteral("not built yet")});
}

void ModbusPort::close() {}

RegisterPort::Done ModbusPort::read(RegisterArea, int, std::span<Register>)
{
    return tl::unexpected(RegisterError{RegisterError::Kind::closed, 0, {}});
}

RegisterPort::Done ModbusPort::write(int, std::span<const Register>)
{
    return tl::unexpected(RegisterError{RegisterError::Kind::closed, 0, {}});
}

RegisterPort::Done ModbusPort::writeAndRead(int, std::span<const Register>, int, std::span<Register>)
{
    return tl::unexpected(RegisterError{RegisterError::Kind::closed, 0, {}});
}

Instant ModbusPort::now() const
{
    return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now() - d->begin);
}

void ModbusPort::wait(Instant until)
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(std::max(until - now(), Instant{}));
    pollfd waited{d->wake.descriptor(), POLLIN, 0};
    ::poll(&waited, 1, static_cast<int>(left.count()));
    d->wake.lower();
}

void ModbusPort::interrupt()
{
    d->wake.raise();
}

QString ModbusPort::name() const
{
    return gatewayText(d->settings);
}

} // namespace codewheel
