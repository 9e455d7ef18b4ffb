// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/ledger_keeper.h"
#include "transfer/transfer_account.h"
#include "vocabulary/message.h"

#include <functional>

namespace codewheel {

class ProjectPlaces;

// What an encoder had before something was written to it: every value that was written and whose previous
// value was known.
struct ValuesBefore
{
    Place place;
    QDateTime at; // of the write
    QString deviceKey;
    ParameterValues values;
    Place writtenAt{}; // where the encoder was then

    friend bool operator==(const ValuesBefore &, const ValuesBefore &) = default;
};

// What can be restored at a place, the newest first.
using FindValuesBefore = std::function<std::vector<ValuesBefore>(Place)>;

// As kept in the ledger; for a job whose end was not seen, everything it was to write. Nothing while it is
// asked whether the encoder there is the same as before. The keeper must outlive it.
FindValuesBefore valuesBeforeOf(const LedgerKeeper &keeper);
// From the keeper of the bus at the place.
FindValuesBefore valuesBeforeOf(FindLedgers ledgers);

// Of an encoder of which nothing was found.
Refusal whyNothingBefore(const EncoderSession &encoder);

// The place is the project's, if there is one: another encoder there may have another past.
TransferWish wishToRestore(const ValuesBefore &before, const ProjectPlaces &places);

// As momentText().
QString timeOf(const ValuesBefore &before, const QDateTime &now);
// "Steps 8 192, Coding 3 (unsigned, CW)"; `device` may be null.
QString textOf(const ValuesBefore &before, const DeviceDescription *device);

// "valuesRestored" for the message log.
Message valuesRestoredMessage(const ValuesBefore &before, const TransferAccount &account);

} // namespace codewheel
