// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

namespace codewheel {

class BusAccess;
class Catalog;
struct Project;
struct Subcommand;
struct Arguments;
struct Terminal;

// The whole of codewheel-cli. `words` are the arguments without the name of the program; returns its exit
// code (cli/complaint.h). Each call has training buses of its own, or what --link leads to.
int runCommandLine(const QStringList &words, const Terminal &terminal);

// Whether this call may write a PDF: that needs fonts, and therefore a QGuiApplication.
bool makesPdf(const QStringList &words);

// One command on these buses, with the project named in the call; null: it names none.
int runCommand(const Subcommand &command, const Arguments &arguments, const Project *project,
               const Catalog &catalog, const std::vector<BusAccess *> &links, const Terminal &terminal);

} // namespace codewheel
