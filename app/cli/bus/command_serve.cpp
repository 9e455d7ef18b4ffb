// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/kinds/link_kind.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr const char *serveExamples[] = {"serve esc --corrupted 10 --seed 7",
                                         "serve canopen --slcan --quirk autostart",
                                         "serve modbus-tcp --address 0.0.0.0 --seats 12",
                                         "serve modbus-tcp --port 1502 --project crane.codewheel --read-only",
                                         "serve modbus-rtu --port ttyUSB0,baud=9600,unit=5"};

bool hasOption(const Service &service, const QString &option)
{
    return std::ranges::any_of(service.options,
                               [&](const Option &its) { return option == QLatin1String(its.name); });
}

QString serviceName(const Service &service)
{
    return QString::fromLatin1(service.name);
}

Checked<void> checkOptions(const Service &service, const Call &call)
{
    for (const Option &option : ownOptionsOf(call.command))
        if (const QString name = QString::fromLatin1(option.name);
            call.arguments.has(option.name) && !hasOption(service, name))
            return badInput(
                "optionOfOtherService", CommandLine::tr("%1 is not for \"serve %2\". Its options are: %3."),
                {name, serviceName(service),
                 listed(service.options, [](const Option &its) { return QString::fromLatin1(its.name); })});
    return {};
}

Checked<Answer> runServe(const Call &call)
{
    const QString what = call.arguments.rest.front();
    const std::vector<Service> all = allServices();
    const auto service = std::ranges::find(all, what, serviceName);
    if (service == all.end())
        return badInput("unknownService", CommandLine::tr("\"%1\" cannot be served. There is: %2."),
                        {what, listed(all, serviceName)});
    return checkOptions(*service, call).and_then([&] { return service->serve(call); });
}

} // namespace

const Subcommand serveCommand{
    .name = "serve",
    .usage = "", // that of the services
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "offer the simulated serial line, CAN bus or ring to other programs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "esc: prints the path of a pseudo terminal, which any program on this computer opens as a serial "
        "port, and\nserves the encoders 03, 05 and 12 there, at the speed of a real line. Baud rates other "
        "than that of the\nencoders give junk.\n\n"
        "canopen: serves the nodes 5, 6 and 7, and an encoder without a number, in real time, behind an "
        "SLCAN "
        "adapter\non a pseudo terminal, the path of which is printed, or on an interface. An adapter opened "
        "at another rate\nthan that of the encoders disturbs the bus, as a real one does. Quirks: autostart, "
        "fixed-mapping,\nhighest-range, keeps-identifiers, keeps-preset, lss-forgets, lss-stopped, "
        "restore-at-once, silent-store,\nspeed-off, switches, writes-pre-operational.\n\n"
        "modbus-tcp, modbus-rtu: offers the process image of the training ring, or of the rings of --project "
        "that are\nlinked to it, as Modbus registers, as a gateway does; several clients at once over TCP. A "
        "write is\nconfirmed once it was on the bus. The ring runs in real time, in Operate.\n\n"
        "Each serves until it is ended with Ctrl+C (SIGINT or SIGTERM)."),
    .examples = serveExamples,
    .options = {}, // those of the services
    .arguments = {1},
    .run = runServe,
};

} // namespace codewheel
