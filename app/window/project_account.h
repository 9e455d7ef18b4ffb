// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class LedgerKeeper;
class ProjectDocument;

// Tells the account of EEPROM writes the file of the project and the serial numbers of its labels, now and
// whenever they change. Both outlive the window.
void keepAccountOf(ProjectDocument &project, LedgerKeeper &ledger);

} // namespace codewheel
