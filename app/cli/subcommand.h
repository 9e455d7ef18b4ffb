// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/answer.h"
#include "cli/arguments.h"
#include "cli/terminal.h"

#include <span>

namespace codewheel {

class BusSession;
class Catalog;
class LedgerKeeper;
struct Project;

// What a command works with.
struct Call
{
    const Arguments &arguments;
    const Catalog &catalog;
    BusSession *bus; // null for commands that need none
    const Terminal &terminal;
    const Project *project; // of --project; null without it
    LedgerKeeper *ledger;   // of the bus; null without one
};

// One command of the command line: how it is called, how it is explained, and what it does. Texts are
// untranslated, in the context codewheel::CommandLine.
struct Subcommand
{
    const char *name;
    const char *usage; // its arguments, as the user types them
    const char *summary;
    const char *details;
    std::span<const char *const> examples; // without the name of the program
    std::span<const Option> options;
    int minimumArguments;
    int maximumArguments;
    bool needsBus;
    const char *busOption = nullptr; // needs it with this option only
    Checked<Answer> (*run)(const Call &call);
};

} // namespace codewheel
