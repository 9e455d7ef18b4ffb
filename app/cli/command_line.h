// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace codewheel {

class BusSession;
class Catalog;
class LedgerKeeper;
struct Subcommand;
struct Arguments;
struct Terminal;

// The whole of codewheel-cli. `words` are the arguments without the name of the program; the answer is its
// exit code (cli/complaint.h). Each call has a training bus of its own.
int runCommandLine(const QStringList &words, const Terminal &terminal);

// Whether this call may write a PDF: that needs fonts, and so a QGuiApplication.
bool makesPdf(const QStringList &words);

// One command on a bus that is there already (null for commands that need none), with the ledger of its
// encoders, if one is kept.
int runCommand(const Subcommand &command, const Arguments &arguments, const Catalog &catalog, BusSession *bus,
               const Terminal &terminal, LedgerKeeper *ledger = nullptr);

} // namespace codewheel
