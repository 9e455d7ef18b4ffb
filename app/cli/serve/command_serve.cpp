// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/line/serve_line.h"
#include "cli/serve/serve_modbus.h"
#include "cli/texts.h"
#include "encoder/sentence.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr const char *serveExamples[] = {"serve esc --corrupted 10 --seed 7",
                                         "serve modbus-tcp --address 0.0.0.0 --seats 12",
                                         "serve modbus-tcp --port 1502 --project crane.codewheel --read-only",
                                         "serve modbus-rtu --port ttyUSB0,baud=9600,unit=5"};

constexpr std::array serveOptions{
    Option{"--lost", "N", QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes, so many are lost")},
    Option{"--corrupted", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes, so many are wrong in one bit")},
    Option{"--doubled", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "of 1000 bytes, so many come twice")},
    Option{"--delayed", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "of 1000 bytes, so many come later, with all that follow them")},
    Option{"--delay", "MS", QT_TRANSLATE_NOOP("codewheel::CommandLine", "how much later (20)")},
    Option{"--answer-delay", "MS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "from a request to its answer (0)")},
    Option{"--echo", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "send back what comes in, as a half-duplex adapter")},
    Option{"--silent", "ADDRESS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "an encoder that does not answer; several as 03,12; all for all of them")},
    Option{"--seed", "N", QT_TRANSLATE_NOOP("codewheel::CommandLine", "another run of the same faults (1)")},
    Option{"--address", "ADDRESS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "of this computer, where others reach it; 0.0.0.0: all it has (127.0.0.1, for "
                             "programs on this computer only)")},
    Option{
        "--port", "PORT",
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "modbus-tcp: its number, 0 for a free one (1502); modbus-rtu: a serial port, with "
                          "settings behind it, as ttyUSB0,baud=9600,unit=5 (a pseudo terminal)")},
    Option{"--seats", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "a ring of its own for each seat: unit 1 to N (one ring for all units)")},
    Option{"--read-only", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "clients may write nothing")},
};

// What can be served, and which of the options are for it.
struct Service
{
    const char *name;
    std::vector<const char *> options;
    Checked<Answer> (*serve)(const Call &call);
};

const std::vector<Service> &services()
{
    static const std::vector<Service> all{
        {"esc",
         {"--lost", "--corrupted", "--doubled", "--delayed", "--delay", "--answer-delay", "--echo",
          "--silent", "--seed"},
         serveLine},
        {"modbus-tcp", {"--address", "--port", "--seats", "--read-only"}, serveModbusTcp},
        {"modbus-rtu", {"--port", "--seats", "--read-only"}, serveModbusRtu},
    };
    return all;
}

Checked<void> checkOptions(const Service &service, const Arguments &arguments)
{
    for (const Option &option : serveOptions) {
        const bool isIts = std::ranges::any_of(service.options, [&](const char *its) {
            return QLatin1String(its) == QLatin1String(option.name);
        });
        if (arguments.has(option.name) && !isIts)
            return badInput(
                QStringLiteral("optionOfOtherService"),
                CommandLine::tr("%1 is not for \"serve %2\". Its options are: %3."),
                {QString::fromLatin1(option.name), QString::fromLatin1(service.name),
                 listed(service.options, [](const char *its) { return QString::fromLatin1(its); })});
    }
    return {};
}

Checked<Answer> runServe(const Call &call)
{
    const QString what = call.arguments.rest.front();
    const auto service =
        std::ranges::find_if(services(), [&](const Service &its) { return what == QLatin1String(its.name); });
    if (service == services().end())
        return badInput(
            QStringLiteral("unknownService"), CommandLine::tr("\"%1\" cannot be served. There is: %2."),
            {what, listed(services(), [](const Service &its) { return QString::fromLatin1(its.name); })});
    return checkOptions(*service, call.arguments).and_then([&] { return service->serve(call); });
}

} // namespace

const Subcommand serveCommand{
    .name = "serve",
    .usage = "esc [--lost N] [--corrupted N] [--doubled N] [--delayed N] [--delay MS] [--answer-delay MS] "
             "[--echo] [--silent ADDRESS] [--seed N] | "
             "modbus-tcp [--address ADDRESS] [--port PORT] [--seats N] [--read-only] | "
             "modbus-rtu [--port PORT] [--seats N] [--read-only]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "offer the simulated serial line or a simulated ring to other programs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "esc: prints the path of a pseudo terminal, which any program on this computer opens as a serial "
        "port, and\nserves the encoders 03, 05 and 12 there, at the speed of a real line. Baud rates other "
        "than "
        "that of the\nencoders give junk.\n\n"
        "modbus-tcp, modbus-rtu: offers the process image of the training ring, or of the rings of --project "
        "that are\nlinked to it, as Modbus registers, as a gateway does; several clients at once over TCP. A "
        "write is\nconfirmed once it was on the bus. The ring runs in real time, in Operate.\n\n"
        "Both serve until they are ended with Ctrl+C (SIGINT or SIGTERM)."),
    .examples = serveExamples,
    .options = serveOptions,
    .minimumArguments = 1,
    .maximumArguments = 1,
    .needsBus = false,
    .run = runServe,
};

} // namespace codewheel
