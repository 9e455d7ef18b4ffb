// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/simulator/simulated_esc_line.h"
#include "serial/byte_link.h"
#include "tests/cli/cli_run.h"

#include <csignal>
#include <memory>

namespace codewheel {

// Calls that share one simulated serial line, in virtual time, without a ring.
class SharedLine
{
public:
    explicit SharedLine(Catalog catalog = Catalog::builtIn())
        : m_catalog(std::move(catalog))
    {}

    // `line` may contain --link esc:training with settings of the line, and --ledger.
    CliRun runLine(const QString &line, const Person &person = {});
    SimulatedEscLine &simulated() { return *m_line; }
    EscRegisters registers(std::uint8_t address);
    void mute(std::uint8_t address);

    // The adapter is unplugged right after a request with this beginning was sent so many times: "05GD".
    void unplugAfter(const QByteArray &request, int times = 1)
    {
        m_cut = {request, [left = times](SimulatedEscLine &line) mutable {
                     if (--left == 0)
                         line.setUnplugged(true);
                 }};
    }
    // From then on all encoders are silent; they still hear and act.
    void muteAfter(const QByteArray &request)
    {
        m_cut = {request, [](SimulatedEscLine &line) { line.setSilent(true); }};
    }

    // Ctrl+C is pressed then, or another signal arrives.
    void interruptAfter(const QByteArray &request, int signal = SIGINT);

    // What happens once a request with this beginning was sent.
    struct Cut
    {
        QByteArray request{};
        std::function<void(SimulatedEscLine &)> happens{};
    };

private:
    Catalog m_catalog;
    std::shared_ptr<SimulatedEscLine> m_line = std::make_shared<SimulatedEscLine>();
    Cut m_cut;
};

// A link that passes everything on, and makes something happen at a certain request.
std::unique_ptr<ByteLink> cutLink(std::shared_ptr<SimulatedEscLine> line, SharedLine::Cut cut);

} // namespace codewheel
