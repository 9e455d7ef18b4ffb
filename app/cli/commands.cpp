// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"

#include "cli/bus/places.h"
#include "cli/kinds/link_kind.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// In the order of the help; those of the kinds of bus come in between.
constexpr std::array firstCommands{
    &devicesCommand,  &scanCommand,   &compareCommand,  &explainCommand, &wordsCommand,  &readCommand,
    &writeCommand,    &presetCommand, &velocityCommand, &resetCommand,   &camsCommand,   &storeCommand,
    &transferCommand, &cloneCommand,  &replaceCommand,  &restoreCommand, &reportCommand, &monitorCommand,
    &recordCommand,   &exportCommand, &framesCommand};
constexpr std::array lastCommands{&serveCommand, &messagesCommand, &ledgerCommand, &findCommand,
                                  &doctorCommand};

constexpr std::array common{
    Option{"--json", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "answer as one JSON object, for programs")},
    Option{"--link", "LINK",
           QT_TRANSLATE_NOOP(
               "codewheel::CommandLine",
               "the way to the encoders: training (the default), the simulated buses; project, all buses of "
               "the project; or SCHEME:WHERE, with settings behind it, as in esc:ttyUSB0,baud=9600")},
    Option{"--project", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "name encoders as this project does; PLACE may be the name of a station")},
    Option{"--fault-plan", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "faults that happen to the training bus, with their times and places")},
    faultBusOption,
    Option{"--help", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "explain this and stop; also -h")},
    Option{"-h", nullptr, nullptr},
    Option{"--version", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "print the version and stop")},
};

// Several may have the same.
void addMissing(std::vector<Option> &options, std::span<const Option> more)
{
    for (const Option &option : more)
        if (std::ranges::find(options, QLatin1String(option.name),
                              [](const Option &has) { return QLatin1String(has.name); }) == options.end())
            options.push_back(option);
}

} // namespace

std::vector<const Subcommand *> allCommands()
{
    std::vector<const Subcommand *> all(firstCommands.begin(), firstCommands.end());
    for (const LinkKind *kind : linkKinds())
        all.insert(all.end(), kind->commands().begin(), kind->commands().end());
    all.insert(all.end(), lastCommands.begin(), lastCommands.end());
    return all;
}

const Subcommand *commandNamed(const QString &name)
{
    const auto all = allCommands();
    const auto found = std::ranges::find_if(
        all, [&](const Subcommand *command) { return name == QLatin1String(command->name); });
    return found == all.end() ? nullptr : *found;
}

std::span<const Option> commonOptions()
{
    return common;
}

std::vector<Option> ownOptionsOf(const Subcommand &command)
{
    std::vector<Option> options(command.options.begin(), command.options.end());
    if (&command == &scanCommand)
        for (const LinkKind *kind : linkKinds())
            options.insert(options.end(), kind->scanOptions().begin(), kind->scanOptions().end());
    if (&command == &serveCommand)
        for (const Service &service : allServices())
            addMissing(options, service.options);
    return options;
}

std::vector<Option> optionsOf(const Subcommand &command)
{
    std::vector<Option> options = ownOptionsOf(command);
    options.insert(options.end(), common.begin(), common.end());
    return options;
}

} // namespace codewheel
