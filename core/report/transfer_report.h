// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "transfer/transfer_account.h"

namespace codewheel {

class Catalog;

// The account of a transfer, to be saved: for each encoder every value, what it was, what became of it, by
// what evidence; EEPROM writes; the state it was left in. `version` of the program.
Report reportOf(const TransferAccount &account, const Catalog &catalog, const QString &version);

// The same as plain text, in columns.
QString reportAsText(const Report &report);

} // namespace codewheel
