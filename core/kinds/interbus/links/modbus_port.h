// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"

#include <memory>

namespace codewheel {

// The registers of a gateway, over TCP or a serial line.
class ModbusPort final : public RegisterPort
{
public:
    explicit ModbusPort(const GatewaySettings &settings);
    ~ModbusPort() override;

    Result<void> open() override;
    void close() override;
    Done read(RegisterArea area, int first, std::span<Register> to) override;
    Done write(int first, std::span<const Register> from) override;
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override;
    Instant now() const override;
    void wait(Instant until) override;
    void interrupt() override;
    QString name() const override;
    Noticed noticed() const override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel
