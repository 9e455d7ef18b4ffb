// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/journal/ledger_account.h"

#include "cli/bus/bus_access.h"
#include "cli/call/texts.h"
#include "journal/ledger_keeper.h"
#include "journal_files.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>

namespace codewheel {

LedgerAccount::LedgerAccount(const std::vector<BusAccess *> &links, const Terminal &terminal)
{
    for (const BusAccess *link : links)
        listenTo(link->ledger(), terminal);
}

void LedgerAccount::listenTo(LedgerKeeper *keeper, const Terminal &terminal)
{
    if (keeper == nullptr)
        return;
    m_keepers.push_back(keeper);
    QObject::connect(keeper, &LedgerKeeper::messaged, &m_scope, [&terminal](const Message &message) {
        if (message.id == MessageId::keptBeside || message.id == MessageId::notKept)
            terminal.complain(messageText(message));
    });
}

std::optional<Complaint> LedgerAccount::complaint() const
{
    if (std::ranges::none_of(m_keepers, &LedgerKeeper::hasUncounted))
        return std::nullopt;
    return notDone("notCounted",
                   CommandLine::tr("The EEPROM writes of this call are not entered in the ledger."));
}

void complainAboutLedgers(const std::vector<BusAccess *> &links, const Terminal &terminal)
{
    if (const QString warning = nothingIsKept(); !warning.isEmpty()) {
        terminal.complain(warning);
        return;
    }
    for (const BusAccess *link : links)
        if (const auto &problem = link->ledger()->problem())
            terminal.complain(messageText(*problem));
}

} // namespace codewheel
