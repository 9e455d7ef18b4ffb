// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/pseudo_terminal.h"
#include "cli/bus/serve_options.h"
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/kinds/esc/esc_line_link_kind.h"
#include "cli/kinds/esc/served_line.h"
#include "kinds/esc/simulator/simulated_esc_line.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace codewheel {
namespace {

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
            return badInput(QStringLiteral("optionNotAllowed"),
                            CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
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
