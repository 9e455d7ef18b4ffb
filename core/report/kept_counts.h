// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_input.h"

namespace codewheel {

class Catalog;
class Ledger;

// Adds the EEPROM writes the ledger knows of encoders whose count is not told by the connected ring: by the
// serial number that was read of them, else by that of their label, else by their place in this project
// (its file; empty: never saved). Where it has none, nobody knows how often that encoder was written to.
void addKept(ReportInput &input, const Ledger &ledger, const Catalog &catalog, const QString &projectFile);

} // namespace codewheel
