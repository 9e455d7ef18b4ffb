// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/pseudo_terminal.h"
#include "cli/bus/serve_options.h"
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/kinds/esc/esc_line_link_kind.h"
#include "kinds/esc/simulator/simulated_esc_line.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace codewheel {
namespace {

// A simulated line behind a pseudo terminal, as seen by another program: what it writes goes out at the speed
// of the line, and comes back as answers. What is written faster than the line carries is dropped once
// `mostWaiting` characters wait, as with a port without flow control, and nothing of it is left for the next
// program. Used by the command serve; time is an argument.
class ServedLine
{
public:
    static constexpr std::size_t mostWaiting = 512; // 0.3 s at 19200 Bd

    ServedLine(SimulatedEscLine &line, PseudoTerminal &port)
        : m_line(line)
        , m_port(port)
    {}

    // Does what is due at `now`; returns when there will be more, if nobody writes.
    std::optional<Instant> serve(Instant now);

private:
    void takeWritten(Instant now);
    void forgetLastClient(Instant now);

    SimulatedEscLine &m_line;
    PseudoTerminal &m_port;
    bool m_isFlooded = false; // by the program that has the port open
};

constexpr int mostPieces = 1'000; // more than the system keeps; then the next one may already be writing

// A rate that no encoder has stands for those the terminal does not know.
int usableRate(int baudRate)
{
    constexpr int noRateOfTheirs = 19'201;
    return baudRate > 0 ? baudRate : noRateOfTheirs;
}

std::optional<Instant> ServedLine::serve(Instant now)
{
    if (m_port.clientLeft())
        forgetLastClient(now);
    for (auto arrived = m_line.advance(now); !arrived.bytes.isEmpty(); arrived = m_line.advance(now))
        m_port.write(arrived.bytes);
    takeWritten(now);
    return m_line.nextEnd();
}

void ServedLine::takeWritten(Instant now)
{
    const QByteArray bytes = m_port.read();
    m_line.setBaudRate(usableRate(m_port.baudRate())); // after reading: it was set before they were written
    const auto waiting = static_cast<qsizetype>(m_line.waiting());
    const qsizetype room = std::max(static_cast<qsizetype>(mostWaiting) - waiting, qsizetype{0});
    m_isFlooded = m_isFlooded || bytes.size() > room;
    if (!bytes.isEmpty())
        m_line.send(bytes.first(std::min(bytes.size(), room)), now);
}

// What it did not read, and what it wrote beyond what the line carries.
void ServedLine::forgetLastClient(Instant now)
{
    m_port.dropUnfetched();
    if (!std::exchange(m_isFlooded, false))
        return;
    for (int piece = 0; piece < mostPieces && !m_port.read().isEmpty(); ++piece)
        ;
    m_line.begin(m_line.settings(), now);
}

constexpr Instant longestWait{500'000};

constexpr std::array serveLineOptions{
    lostOption,
    Option{"--corrupted", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes, so many are wrong in one bit")},
    doubledOption,
    delayedOption,
    delayOption,
    Option{"--answer-delay", "MS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "from a request to its answer (0)")},
    Option{"--echo", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "send back what comes in, as a half-duplex adapter")},
    silentOption,
    seedOption,
};

struct ServePlan
{
    EscLineFaults faults;
    Instant answerDelay = SimulatedEscLine::usualAnswerDelay;
    std::vector<EscLineAddress> silent;
    std::uint32_t seed = 1;
};

Checked<std::vector<EscLineAddress>> silentOnes(const Arguments &arguments)
{
    std::vector<EscLineAddress> there;
    for (const EscEncoderPlan &encoder : trainingLine())
        there.push_back(encoder.address);
    const QString given = arguments.value("--silent").value_or(QString());
    if (given == QStringLiteral("all"))
        return there;
    std::vector<EscLineAddress> silent;
    for (const QString &text : given.split(u',', Qt::SkipEmptyParts)) {
        const auto address = EscLineAddress::fromWire(text);
        if (!address || std::ranges::find(there, *address) == there.end())
            return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                            {QStringLiteral("--silent"), text, QStringLiteral("03, 05, 12, all")});
        silent.push_back(*address);
    }
    return silent;
}

Checked<void> takeLineFaults(const Arguments &arguments, ServePlan &plan)
{
    int delay = 0;
    int answerDelay = 0;
    int seed = 0;
    const ServedNumber rows[] = {
        {"--lost", 0, 0, mostOfThousand, plan.faults.lost},
        {"--corrupted", 0, 0, mostOfThousand, plan.faults.corrupted},
        {"--doubled", 0, 0, mostOfThousand, plan.faults.doubled},
        {"--delayed", 0, 0, mostOfThousand, plan.faults.delayed},
        {"--delay", usualServedDelay, 1, longestServedDelay, delay},
        {"--answer-delay", 0, 0, longestServedDelay, answerDelay},
        {"--seed", 1, 0, largestSeed, seed},
    };
    if (const auto taken = takeNumbers(arguments, rows); !taken)
        return taken;
    plan.faults.delay = std::chrono::milliseconds(delay);
    plan.answerDelay += std::chrono::milliseconds(answerDelay);
    plan.seed = static_cast<std::uint32_t>(seed);
    return {};
}

Checked<ServePlan> planOf(const Arguments &arguments)
{
    ServePlan plan;
    plan.faults.echo = arguments.has("--echo");
    if (const auto taken = takeLineFaults(arguments, plan); !taken)
        return tl::unexpected(taken.error());
    const auto silent = silentOnes(arguments);
    if (!silent)
        return tl::unexpected(silent.error());
    plan.silent = *silent;
    return plan;
}

void prepare(SimulatedEscLine &line, const ServePlan &plan)
{
    line.setFaults(plan.faults);
    line.setAnswerDelay(plan.answerDelay);
    for (const EscLineAddress address : plan.silent)
        line.withEncoder(address, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    line.begin({});
}

void serve(ServedLine &line, const PseudoTerminal &port, StopSignals &stop)
{
    using std::chrono::steady_clock;
    const auto begin = steady_clock::now();
    while (!stop.came()) {
        const auto now = std::chrono::duration_cast<Instant>(steady_clock::now() - begin);
        const Instant next = line.serve(now).value_or(now + longestWait);
        port.wait(stop.descriptor(), std::clamp(next - now, Instant{}, longestWait));
    }
}

Checked<Answer> serveLine(const Call &call)
{
    const auto plan = planOf(call.arguments);
    if (!plan)
        return tl::unexpected(plan.error());
    auto port = PseudoTerminal::make();
    if (!port)
        return tl::unexpected(noPseudoTerminal());
    SimulatedEscLine line(trainingLine(), plan->seed);
    prepare(line, *plan);
    ServedLine served(line, *port);
    StopSignals stop;
    call.terminal.print(port->path() + u'\n');
    if (call.terminal.canPrint()) // otherwise nobody knows the port
        serve(served, *port, stop);
    return Answer{{}, {{QStringLiteral("port"), port->path()}}};
}

} // namespace

const Service lineService{"esc", serveLineOptions, serveLine};

} // namespace codewheel
