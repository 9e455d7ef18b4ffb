// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/answer.h"
#include "cli/call/arguments.h"
#include "cli/call/terminal.h"
#include "vocabulary/place.h"

#include <QtGlobal>

#include <limits>
#include <span>
#include <vector>

namespace codewheel {

class Buses;
class BusAccess;
class Catalog;
struct Project;
struct Subcommand;

// What a command works with.
struct Call
{
    const Subcommand &command;
    const Arguments &arguments;
    const Catalog &catalog;
    const Terminal &terminal;
    std::vector<BusAccess *> links; // the buses that the link leads to; empty for a command that needs none
    const Buses &buses;             // those of them that are open
    const Project *project;         // from --project; null without it
    const Project *named;           // the first argument; null for commands that name none

    BusAccess *findBus(BusId bus) const; // null: the link does not lead there
    BusAccess &busOf(Place place) const; // of an encoder of the call
};

// How many arguments a command takes, besides its options.
struct ArgumentCount
{
    static constexpr int any = std::numeric_limits<int>::max();

    int least = 0;
    int most = least;
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
    ArgumentCount arguments{};
    bool needsBus = false;
    bool needsLinks = false;         // for what is known of its buses before they are opened
    const char *busOption = nullptr; // needs it only with this option
    bool namesProject = false;       // its first argument is a project
    bool answersInLines = false;     // with --json: one line per object, the last one as for every command
    bool textIsAccount = false;      // the text of its answer tells what was done to encoders or files
    Checked<Answer> (*run)(const Call &call);
};

} // namespace codewheel
