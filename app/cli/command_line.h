// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace codewheel {

class Catalog;
struct Subcommand;
struct Arguments;
struct Connection;
struct Terminal;

// The whole of codewheel-cli. `words` are the arguments without the name of the program; the answer is its
// exit code (cli/complaint.h). Each call has a training bus of its own, or the serial line of --link.
int runCommandLine(const QStringList &words, const Terminal &terminal);

// Whether this call may write a PDF: that needs fonts, and so a QGuiApplication.
bool makesPdf(const QStringList &words);

// One command on what is connected already.
int runCommand(const Subcommand &command, const Arguments &arguments, const Catalog &catalog,
               const Connection &connection, const Terminal &terminal);

} // namespace codewheel
