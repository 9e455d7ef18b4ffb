// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "journal/ledger.h"

namespace codewheel {

// The file of the call, otherwise the user's own.
QString ledgerMeant(const Call &call);

// Looking creates no file: empty if there is none.
Checked<std::optional<Ledger>> existingLedger(const QString &file);
Complaint aboutLedger(const QString &file, const DatabaseError &error);

// All entries in a file, for another computer.
Checked<Answer> exportLedger(const Call &call, const QString &target);
// Takes in such files: all of them, or none.
Checked<Answer> importLedgers(const Call &call, const QStringList &sources);
// Takes in what other computers left in a folder, and leaves there what is known here, in the file of this
// computer. A file that cannot be read is named, and stays as it is.
Checked<Answer> mergeLedgerFolder(const Call &call, const QString &folder);

} // namespace codewheel
