// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"

namespace codewheel {

// One file each: command_devices.cpp, ... Kinds of bus add more (link_kind.h).
extern const Subcommand devicesCommand;
extern const Subcommand scanCommand;
extern const Subcommand compareCommand;
extern const Subcommand explainCommand;
extern const Subcommand wordsCommand;
extern const Subcommand readCommand;
extern const Subcommand writeCommand;
extern const Subcommand presetCommand;
extern const Subcommand velocityCommand;
extern const Subcommand resetCommand;
extern const Subcommand camsCommand;
extern const Subcommand storeCommand;
extern const Subcommand transferCommand;
extern const Subcommand cloneCommand;
extern const Subcommand replaceCommand;
extern const Subcommand restoreCommand;
extern const Subcommand reportCommand;
extern const Subcommand monitorCommand;
extern const Subcommand recordCommand;
extern const Subcommand exportCommand;
extern const Subcommand framesCommand;
extern const Subcommand doctorCommand;
extern const Subcommand findCommand;
extern const Subcommand serveCommand;
extern const Subcommand messagesCommand;
extern const Subcommand ledgerCommand;

// In the order of the help.
std::vector<const Subcommand *> allCommands();
const Subcommand *commandNamed(const QString &name);
// The ones that every command has, --json first.
std::span<const Option> commonOptions();
std::vector<Option> ownOptionsOf(const Subcommand &command);
// Its own and the common ones.
std::vector<Option> optionsOf(const Subcommand &command);

} // namespace codewheel
