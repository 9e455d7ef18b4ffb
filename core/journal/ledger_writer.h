// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// Who made an entry of the ledger.
struct LedgerWriter
{
    QString computer{}; // its host name; empty: not known
    QString user{};     // the name given in Settings; empty: none

    friend bool operator==(const LedgerWriter &, const LedgerWriter &) = default;
};

// Of what this program enters from now on.
LedgerWriter ledgerWriter();

// The name the user gives; empty: none. It is cut after longestUserName characters.
inline constexpr int longestUserName = 80;
void setLedgerUser(const QString &name);

} // namespace codewheel
