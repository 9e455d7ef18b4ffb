// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger.h"

class QSqlQuery;
class QVariant;

namespace codewheel {

// The columns of the table of entries.
inline constexpr QLatin1String
    ledgerColumns("id, at, identity, counted_by, place, device, planned, writes, settled, before, "
                  "written");
// Of an entry that counts: it has not ended without a write.
inline constexpr QLatin1String hasWrites("NOT (settled AND writes <= 0)");

// The entries that meet the condition, by id, with what belongs to them; and what a row of that holds.
QString ledgerQuery(const QString &condition);
Ledger::Record ledgerRecordOf(const QSqlQuery &row);
// The values in a column of that kind.
std::vector<Ledger::Value> ledgerValues(const QVariant &column);

} // namespace codewheel
