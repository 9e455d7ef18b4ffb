// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/kinds/esc/shared_line.h"

#include "cli/call/command_line.h"
#include "cli/call/stop_signals.h"
#include "cli/commands.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <csignal>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

class CutLink final : public ByteLink
{
public:
    CutLink(std::shared_ptr<SimulatedEscLine> line, SharedLine::Cut cut)
        : m_line(std::move(line))
        , m_link(m_line)
        , m_cut(std::move(cut))
    {}

    Result<void> open(const SerialSettings &settings) override { return m_link.open(settings); }
    void close() override { m_link.close(); }
    Result<void> setBaudRate(int baudRate) override { return m_link.setBaudRate(baudRate); }
    Instant now() const override { return m_link.now(); }
    Result<void> write(const QByteArray &bytes) override
    {
        auto written = m_link.write(bytes);
        if (m_cut.happens && bytes.sliced(1).startsWith(m_cut.request))
            m_cut.happens(*m_line);
        return written;
    }
    Result<QByteArray> read(Instant until) override { return m_link.read(until); }
    QString name() const override { return m_link.name(); }
    bool isSimulated() const override { return true; }
    void interrupt() override { m_link.interrupt(); }
    void wait(Instant until) override { m_link.wait(until); }

private:
    std::shared_ptr<SimulatedEscLine> m_line;
    SimulatedEscLineLink m_link;
    SharedLine::Cut m_cut;
};

} // namespace

CliRun SharedLine::runLine(const QString &line, const Person &person)
{
    QStringList words = line.split(u' ', Qt::SkipEmptyParts);
    const Subcommand *command = commandNamed(words.takeFirst());
    const auto arguments = parseArguments(words, optionsOf(*command), {});
    if (!arguments) {
        ADD_FAILURE() << line.toStdString();
        return {};
    }
    const auto link =
        lineMeant(*LinkText::parse(arguments->value("--link").value_or(QStringLiteral("esc:training"))));
    EXPECT_TRUE(link) << line.toStdString();
    StopSignals held; // so that only the command gets Ctrl+C
    CliRun run = runWith(person, [&](const Terminal &terminal) {
        EscLineAccess access(cutLink(m_line, m_cut), *link, m_catalog);
        access.keepLedger(arguments->value("--ledger"));
        return runOn(*command, *arguments, m_catalog, {&access}, terminal);
    });
    while (held.came()) {
    }
    return run;
}

std::unique_ptr<ByteLink> cutLink(std::shared_ptr<SimulatedEscLine> line, SharedLine::Cut cut)
{
    return std::make_unique<CutLink>(std::move(line), std::move(cut));
}

void SharedLine::interruptAfter(const QByteArray &request, int signal)
{
    m_cut = {request, [signal](SimulatedEscLine &) { std::raise(signal); }};
}

EscRegisters SharedLine::registers(std::uint8_t address)
{
    EscRegisters registers;
    EXPECT_TRUE(m_line->withEncoder(
        {address}, [&](const SimulatedEscEncoder &encoder) { registers = encoder.registers(); }));
    return registers;
}

void SharedLine::mute(std::uint8_t address)
{
    m_line->withEncoder({address}, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
}

} // namespace codewheel
