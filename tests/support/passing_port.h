// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"

#include <memory>
#include <utility>

namespace codewheel::test {

// A port that passes everything on to another one, for ports that change what passes, or stop it.
class PassingPort : public RegisterPort
{
public:
    explicit PassingPort(std::unique_ptr<RegisterPort> port)
        : m_port(std::move(port))
    {}

    Result<void> open() override { return m_port->open(); }
    void close() override { m_port->close(); }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        return m_port->read(area, first, to);
    }
    Done write(int first, std::span<const Register> from) override { return m_port->write(first, from); }
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override
    {
        return m_port->writeAndRead(writeFirst, from, readFirst, to);
    }
    Instant now() const override { return m_port->now(); }
    void wait(Instant until) override { m_port->wait(until); }
    void interrupt() override { m_port->interrupt(); }
    QString name() const override { return m_port->name(); }

private:
    std::unique_ptr<RegisterPort> m_port;
};

} // namespace codewheel::test
