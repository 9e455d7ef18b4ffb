// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_input.h"

namespace codewheel {

class Catalog;
class Ledger;

// Adds the EEPROM writes from the ledger for encoders whose count does not come from the connected ring: by
// the serial number read from them, otherwise by that on their label, otherwise by their place in this
// project (its file; empty: never saved). If the ledger has none, nobody knows how often that encoder was
// written to.
void addKept(ReportInput &input, const Ledger &ledger, const Catalog &catalog, const QString &projectFile);

} // namespace codewheel
