// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"

#include <QObject>

namespace codewheel {

class LedgerKeeper;

// Whether the EEPROM writes of a call get into the ledger. Problems with the file are reported at once, and
// at the end of the call for its exit code.
class LedgerAccount
{
public:
    LedgerAccount(const std::vector<BusAccess *> &links, const Terminal &terminal);

    // Empty: everything is entered.
    std::optional<Complaint> complaint() const;

private:
    void listenTo(LedgerKeeper *keeper, const Terminal &terminal);

    std::vector<const LedgerKeeper *> m_keepers;
    QObject m_scope;
};

// What was wrong with their files when they were opened.
void complainAboutLedgers(const std::vector<BusAccess *> &links, const Terminal &terminal);

} // namespace codewheel
