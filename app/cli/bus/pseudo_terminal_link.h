// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/pseudo_terminal.h"
#include "links/wake_flag.h"
#include "serial/byte_link.h"

namespace codewheel {

// The other end of a serial line that is a pseudo terminal: what a program there writes is read here. Any
// baud rate will do. Used by serve modbus-rtu.
class PseudoTerminalLink final : public ByteLink
{
public:
    explicit PseudoTerminalLink(PseudoTerminal terminal);

    Result<void> open(const SerialSettings &) override { return {}; }
    void close() override {}
    Result<void> setBaudRate(int) override { return {}; }
    Instant now() const override;
    void wait(Instant until) override;
    Result<void> write(const QByteArray &bytes) override;
    Result<QByteArray> read(Instant until) override;
    QString name() const override { return m_terminal.path(); }
    void interrupt() override { m_wake.raise(); }

private:
    PseudoTerminal m_terminal;
    WakeFlag m_wake;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace codewheel
