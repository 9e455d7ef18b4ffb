// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "journal/ledger_keeper.h"
#include "transfer/transfer_account.h"

#include <functional>

namespace codewheel {

class ProjectPlaces;

// What an encoder had before something was written to it: of each value that was written and was known
// before.
struct ValuesBefore
{
    Place place;
    QDateTime at; // of the write
    QString deviceKey;
    ParameterValues values;
    Place writtenAt{}; // where the encoder stood then

    friend bool operator==(const ValuesBefore &, const ValuesBefore &) = default;
};

// What there is to restore at a place, the newest first.
using FindValuesBefore = std::function<std::vector<ValuesBefore>(Place)>;

// As the ledger keeps them; of a job whose end was not seen, all that it was to write. The keeper must
// outlive it.
FindValuesBefore valuesBeforeOf(const LedgerKeeper &keeper);
// Of the one that keeps the bus at the place.
FindValuesBefore valuesBeforeOf(FindLedgers ledgers);

// The place is that of the project, where there is one: another encoder there may have another past.
TransferWish wishToRestore(const ValuesBefore &before, const ProjectPlaces &places);

// "14:02", with the date where it was not on the day of `now`; by locale.
QString timeOf(const ValuesBefore &before, const QDateTime &now);
// "Steps 8 192, Coding 3 (unsigned, CW)"; `device` may be null.
QString textOf(const ValuesBefore &before, const DeviceDescription *device);

// "valuesRestored" for the message log.
Message valuesRestoredMessage(const ValuesBefore &before, const TransferAccount &account);

} // namespace codewheel
