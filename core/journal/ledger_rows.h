// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger.h"

class QSqlQuery;

namespace codewheel {

// The columns of an entry, and what a row with them holds.
inline constexpr QLatin1String
    ledgerColumns("id, at, identity, counted_by, place, device, planned, writes, settled, before, "
                  "written");
Ledger::Entry ledgerEntryOf(const QSqlQuery &row);

} // namespace codewheel
