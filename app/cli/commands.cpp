// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr std::array commands{
    &devicesCommand,  &scanCommand,     &compareCommand,  &explainCommand,  &wordsCommand,  &readCommand,
    &writeCommand,    &presetCommand,   &velocityCommand, &resetCommand,    &camsCommand,   &storeCommand,
    &transferCommand, &cloneCommand,    &replaceCommand,  &restoreCommand,  &reportCommand, &monitorCommand,
    &masterCommand,   &terminalCommand, &serveCommand,    &messagesCommand, &ledgerCommand};

constexpr std::array common{
    Option{"--json", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "answer as one JSON object, for programs")},
    Option{"--link", "LINK",
           QT_TRANSLATE_NOOP(
               "codewheel::CommandLine",
               "the way to the encoders: training (the default), the simulated bus; or esc:PORT, a "
               "serial line, with settings behind the port as in esc:ttyUSB0,baud=9600")},
    Option{"--project", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "name encoders as this project does; PLACE may be the name of a station")},
    Option{"--fault-plan", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "faults that befall the training bus, with their times and places")},
    Option{"--help", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "explain this and stop; also -h")},
    Option{"-h", nullptr, nullptr},
    Option{"--version", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "print the version and stop")},
};

} // namespace

std::span<const Subcommand *const> allCommands()
{
    return commands;
}

const Subcommand *findCommand(const QString &name)
{
    const auto found = std::ranges::find_if(
        commands, [&](const Subcommand *command) { return name == QLatin1String(command->name); });
    return found == commands.end() ? nullptr : *found;
}

std::span<const Option> commonOptions()
{
    return common;
}

std::vector<Option> optionsOf(const Subcommand &command)
{
    std::vector<Option> options(command.options.begin(), command.options.end());
    options.insert(options.end(), common.begin(), common.end());
    return options;
}

} // namespace codewheel
