// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/answer.h"
#include "cli/arguments.h"
#include "cli/terminal.h"

#include <QtGlobal>

#include <span>

namespace codewheel {

class Buses;
class BusSession;
class Catalog;
class LedgerKeeper;
class LineAccess;
struct Project;

// What the link of a call leads to. A command that needs no encoders has nothing of it.
struct Connection
{
    BusSession *bus = nullptr;      // INTERBUS; null where the link is a serial line
    LineAccess *line = nullptr;     // a serial line; null where there is none
    LedgerKeeper *ledger = nullptr; // of the bus; null without one
};

// What a command works with.
struct Call : Connection
{
    const Buses &buses; // of them, as far as they are open: a serial line is opened when it is needed
    const Arguments &arguments;
    const Catalog &catalog;
    const Terminal &terminal;
    const Project *project;   // of --project; null without it
    const char *whyNotOnLine; // as of the command
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
    bool needsBus;                   // or a serial line
    const char *busOption = nullptr; // needs it with this option only
    // Why it does not work with encoders on a serial line; null: it does.
    const char *whyNotOnLine = nullptr;
    bool namesProject = false;   // its first argument is a project
    bool answersInLines = false; // with --json: a line for each object, the last one as of every command
    bool textIsAccount = false;  // the text of its answer tells what was done to encoders or files
    Checked<Answer> (*run)(const Call &call);
};

} // namespace codewheel
